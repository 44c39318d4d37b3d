"""With exact visibility the optimum falls neither with smaller regions nor with smaller elements."""
from lab import planning

plan = planning.load("subdivision", "plan")


def check(rows, config, require):
    grid = plan.runs(config)

    def proved(key):
        row = rows[grid[key].key]
        return row["result"]["optimal_regions"] if key in grid and not row["failure"] and row["result"]["proved"] else None

    for (name, backend, area, regions), run in grid.items():
        if backend != "exact":
            continue
        here = proved((name, backend, area, regions))
        for coarser in ((name, backend, area, regions // 4), (name, backend, 2 * area, regions)):
            if coarser in grid and here is not None and proved(coarser) is not None:
                require(proved(coarser) <= here, f"{run.key}: {here} regions, but {proved(coarser)} for the coarser {grid[coarser].key}")
                require(proved(coarser) <= rows[run.key]["result"]["viewpoints"],
                        f"{run.key}: fewer viewpoints than regions are proved to be needed in {grid[coarser].key}")
