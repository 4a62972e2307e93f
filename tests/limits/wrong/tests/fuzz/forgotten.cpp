// A target without a row.
