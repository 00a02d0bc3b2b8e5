"""Questions as people type them, put into the words of the grammar.

    How fast is the left block when it has dropped by h?      ->      speed of left when x1 = h

1. `naming`: what stands for an element of the model (`the rope`, `block A`, `mass m1`, `end of the crank`) becomes its
   name, in every way that it can be meant.
2. `lexicon`: rules of a language, one file each, found by themselves, replace words and forms by those of the grammar.
   A language other than English ends in English words, from which the English rules go on.
3. The grammar reads what comes of it. Nothing is dropped on the way but articles and the like, so that a word that is
   understood by nobody leaves a text that cannot be read; what can be read in two ways is refused, with both.
"""
