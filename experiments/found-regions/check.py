"""A region was found, its optimum proved, and closing cracks and gaps shows no more than there was."""
from lab import planning

plan = planning.load("found-regions", "plan")


def check(rows, config, require):
    for (name, healed), run in plan.runs(config, []).items():
        row = rows[run.key]
        if row["failure"]:
            continue
        require(row["result"]["proved"], f"{run.key}: the optimum is not proved")
        region = rows[run.needs[0].key]["result"]
        require(region["area"] > 0 and region["parts"] == row["result"]["regions"], f"{run.key}: not the regions that were found")
        repairs = row["bundle"]["record"]["scene"]["repairs"]
        require(healed or repairs["healed_vertices"] + repairs["healed_edges"] + repairs["healed_faces"] == 0, f"{run.key}: healed without being asked")
        if not healed:
            wide = row["bundle"]["record"]["results"]["wide"]
            require(wide["proved"], f"{run.key}: the optimum without narrow gaps is not proved")
            require(wide["visible_elements"] <= row["result"]["visible_elements"], f"{run.key}: closed gaps show more")
        require(repairs["largest_healing_move"] <= config["scenes"][name]["heal"], f"{run.key}: moved farther than asked")
