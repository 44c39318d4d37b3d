# The workflow, where snakemake looks for one: see experiments/README.md.
include: "experiments/Snakefile"


rule everything:
    default_target: True
    input: rules.all.input
