"""Exercises for learning platforms: one bank of them, and a file for each platform that writes and reads its packages.

bank        what an exercise is, free of any platform
making      a bank from systems, by what sheets, derivations and marking know
sampling    states of a model at which formulas can be compared in numbers
typed       formulas as platforms take them, and back
formulas    an item as it is asked for a formula
questions   the questions that platforms with formulas make of an item
notes       what students are told about typing
markup      texts and blocks as the HTML that platforms show
selftests   what a package must say to answers whose verdict is known
xml         written without surprises, read without entities
qti         an item of QTI as it is read
moodle      what the formats of Moodle share
asked       the form of a question where no formulas are taken
package     files of a package, written whole or not at all
export      from systems to a package that has passed its self-tests
platforms   a file each, found by itself
prairielearn, numbas   what stands in every package for these
"""
