"""STACK, the question type of Moodle that computes with Maxima: formulas, texts, trees of potential responses, and our own reader of what
was written."""
