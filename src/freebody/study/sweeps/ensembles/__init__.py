"""Motions of many copies of one model by its own equations, written as straight-line code: what the symbolic route
derives (`equations`) is compiled for processors or graphics cards (`numeric.ensemble`), followed (`evaluator`) and
compared with the engine (`beside`)."""
