"""What all experiments share: jobs, how one runs, rows, checks, tables and figures."""
