"""STACK, the question type of Moodle that computes with Maxima.

maxima      formulas in its language
castext     texts and blocks
comparing   formulas in numbers, in Maxima and in Python
formula, number, choice   the parts of a question
writing     an item as a question
xml_file    the file that Moodle imports
seeds       which seed gives which variant
reading     our own reader
"""
