"""The compiled kernels: everything that is translated to machine code when the package is built, and nothing else.

Files of this folder import each other and NumPy alone, so that they can be compiled where nothing else is installed
(only `library`, which is not compiled, knows the errors). What Python calls are entries (`declaring`); `library` finds
them in the shared library that `tools/build_kernels.py` made.
"""
