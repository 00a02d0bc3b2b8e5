"""Questions as people type them, in the words of the grammar.

    in_english_nouns(text, language)    compounds.py    what things are called elsewhere; words that are
written as one
    without_context(names, elements, text)   context.py    what before a question only describes the system
    spelt_out(elements, text, language)   symbols.py      N_A, v_B, omega_2 in words
    linked(elements, text)          naming.py      words for what the model has: names (elements.py, telling.py)
    words_of(text, language)        words.py       every other word: what it means (lexicon.py, a file a language)
    meanings(names, words)          meaning.py     what the words ask for together, in the words of the grammar
    understood(names, text, read)       understanding.py    the way to mean a text that the grammar reads
    parts(elements, text)           several.py      the questions that are asked in one
    is_kept(names, words, text)         keeping.py          whether what is understood has all that was named
    is_of_kind(names, words, text, asked)   kinds.py    whether its value is of the kind that the words ask for

Between words and meanings a sentence is parted into clauses (sentence.py); a clause is a condition (events.py), a
quantity (asking.py, with a room for each family: of_motion.py, polar.py, of_forces.py with at_joints.py and
transmitting.py, of_springs.py, of_transmissions.py, of_sections.py, of_systems.py; what a question word and a verb ask
for together says frames.py), at an instant (instants.py), up to an event
(counting.py, averages.py), whether it comes (whether.py),
or a question turned round (turning_round.py, and what is to be so in so_that.py). Where an equation
says when, what else is said of that instant describes it (stated.py); up to which value of a parameter rest
lasts is put in many ways
(limits.py).
What a model has for words that name nothing stands in lookup.py, joining.py (connections), poses.py (what hangs,
stands, lies level), strings.py, losing.py (what takes energy away) and given.py (parameters by what they are of).
Words that say no more than others beside them are left out (unneeded.py). A speed for that of something else is a
ratio (geared.py), that at which something is lifted or arrives is told in speeds.py;
words put as others put them are told before clauses are
parted (rewording.py; beginning.py: what begins, varies, settles), and where something is meant within a clause in
within.py. What is said of other values than the file gives is told in other_values.py, with its wording in a file of
its own (xx.values.toml); forces that nobody chooses are told from others in unchosen.py, and what is assumed in
assumed.py. Who takes part in a blow is told in striking.py. One quantity at two instants is compared in
at_two_instants.py, and two questions in one in relating.py; what another value of a parameter does to a quantity is in
changing.py, and shares of what something starts with in shares.py.
A parameter that is asked for by what it is has its symbol put in sought.py; which way a vector
points is asked in pointing.py, and things are told by the side on which they lie in by_side.py. Parts that no reading
has taken as they stand are put in the order of the grammar (recomposing.py); long constructions of a text that is not
understood in plainer ones (restating.py). Verbs of a file stand for all their
forms (inflecting.py, strong_verbs.py). Nothing that is said is dropped, but words that lead to a question, adjectives
that tell no thing
from another, and adverbs of manner.
"""
