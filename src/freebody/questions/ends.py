"""Words for the two ends of a range, as they stand in the patterns of the grammar."""

GREATEST = "greatest|largest|maximum|maximal|highest"
LEAST = "least|smallest|minimum|minimal|lowest"
