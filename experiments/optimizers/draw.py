"""How often each optimizer finds the optimum, and how soon."""
from lab import figures, planning, tables

plan = planning.load("optimizers", "plan")


def outcome(found, optimum):
    """Found so often, mean size, mean seconds until the best was there."""
    found = [row["result"] for row in found if not row["failure"]]
    if not found:
        return None
    hits = sum(result["size"] == optimum for result in found)
    return (hits, len(found), sum(result["size"] for result in found) / len(found),
            sum(result["best_after_seconds"] for result in found) / len(found))


def shown(result):
    if result is None:
        return "no result"
    hits, seeds, mean, seconds = result
    return f"{hits}/{seeds}, {mean:.2f}, {tables.number(seconds, 2)}"


def draw(rows, config, folder, work):
    covers, sizes, lines, success = plan.covers(config), {}, [], {method: [] for method in plan.METHODS}
    for key, cover in plan.exact_covers(config).items():
        row = rows[cover.key]
        if row["failure"]:
            continue
        exact, proof = row["result"], rows[plan.proofs(config)[key].key]["result"]
        sizes[key] = exact["size"]
        line = [*key, exact["size"], "yes" if exact["proved"] else f"no, ≥ {exact['lower_bound']}", "holds" if proof else "", tables.number(exact["seconds"])]
        for method in plan.METHODS:
            result = outcome([rows[job.key] for asked, job in covers.items() if asked[:4] == (*key, method)], exact["size"])
            line.append(shown(result))
            success[method].append(100 * result[0] / result[1] if result else 0)
        lines.append(line)
    tables.write(folder / "optimizers", f"Fewest regions by each optimizer: seeds that found the optimum, mean regions, mean seconds until its best was there. One "
                 f"thread; local is stopped after {config['local_seconds']} s.", ["scene", "backend", "regions", "optimum", "proved", "proof", "exact, s", *plan.METHODS], lines)
    annealing(rows, config, sizes, folder)
    figure, ax = figures.axes("", "seeds that found the optimum, %")
    width = 0.8 / len(plan.METHODS)
    for i, method in enumerate(plan.METHODS):
        ax.bar([place + i * width for place in range(len(sizes))], success[method], width, label=method, color=figures.COLOURS[i])
    ax.set_xticks([place + 0.3 for place in range(len(sizes))], [" ".join(map(str, key)) for key in sizes], rotation=60, ha="right", fontsize=7)
    ax.legend(fontsize=8, loc="upper left", bbox_to_anchor=(1, 1))
    figures.save(figure, folder / "success")


def annealing(rows, config, sizes, folder):
    regions = config.get("sweep_regions", config["regions"][-1])
    covers, lines = plan.sweep(config), []
    for schedule in plan.schedules(config):
        line = [schedule or "default"]
        for name in config["scenes"]:
            found = [rows[job.key] for key, job in covers.items() if key[:2] == (name, schedule)]
            line.append(shown(outcome(found, sizes.get((name, "rays", regions)))))
        lines.append(line)
    tables.write(folder / "annealing", f"Annealing with other schedules, {regions} regions, random rays: seeds that found the optimum, mean regions, mean seconds.",
                 ["schedule", *config["scenes"]], lines)
