"""One line a scene."""
from lab import planning, tables

plan = planning.load("found-regions", "plan")


def draw(rows, config, folder, work):
    runs, inspections, lines = plan.runs(config, []), plan.inspections(config, []), []
    for name in dict.fromkeys(key[0] for key in runs):
        region, open_run, healed_run = (rows[job.key] for job in (runs[name, False].needs[0], runs[name, False], runs[name, True]))
        failure = next((row["failure"] for row in (region, open_run, healed_run) if row["failure"]), None)
        if failure:
            lines.append([name, failure, *[""] * 16])
            continue
        cracks, a, b = rows[inspections[name].key]["result"]["cracks"], open_run["result"], healed_run["result"]
        wide = open_run["bundle"]["record"]["results"]["wide"]
        repairs = healed_run["bundle"]["record"]["scene"]["repairs"]
        lines.append([name, cracks["vertices_beside_edges"] + cracks["vertices_beside_faces"] + cracks["unmerged_vertices"], tables.number(cracks["widest"]),
                      tables.number(region["result"]["area"]), region["result"]["parts"], region["result"]["holes"], a["visible_elements"], a["links"],
                      a["optimal_regions"], repairs["healed_vertices"] + repairs["healed_edges"] + repairs["healed_faces"], b["visible_elements"], b["links"], b["optimal_regions"],
                      config["scenes"][name]["aperture"], wide["gaps"], wide["narrow_pairs"], wide["visible_elements"], wide["optimal_regions"]])
    tables.write(folder / "found_regions", f"{config['regions']} region a part of the free space that was found, exact.",
                 ["scene", "cracks", "widest", "free area", "parts", "holes", "elements seen", "links", "optimal regions", "places closed", "elements seen ",
                  "links ", "optimal regions ", "aperture", "patches", "narrow pairs", "elements seen  ", "optimal regions  "], lines)
