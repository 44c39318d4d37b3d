"""first_free_ray.py PROGRAM DIR OCCLUDERS QUERIES MOST WIDTH SEED: how many random rays a visible pair takes before one is free.

Two unit squares a unit apart, random triangles between them: corners uniform in a box WIDTH wide and long and 0.2 high round a centre that is
uniform in the cube, at least 0.2 from the squares. A line from square to square is free of n of them with probability about exp(-0.076 n WIDTH^2). Each query is asked exactly, and if visible, with 1, 2, 4, ... rays until one is free. Prints one JSON object: queries by kind, and of
the visible ones the least such number of rays, sorted; null where not even MOST rays found a free one.
"""
import json
import random
import subprocess
import sys


def query(number, occluders, width, numbers):
    triangles = []
    for _ in range(occluders):
        centre = [numbers.random(), numbers.random(), 0.2 + 0.6 * numbers.random()]
        triangles.append([[x + size * (numbers.random() - 0.5) for x, size in zip(centre, (width, width, 0.2))] for _ in range(3)])
    return {"id": number, "region": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], "element": [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]],
            "occluders": triangles}


def answers(program, queries, *options):
    done = subprocess.run([program, "sees", "--quiet", "--threads", "1", *options], input="".join(json.dumps(one) + "\n" for one in queries),
                          stdout=subprocess.PIPE, text=True, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def main():
    program, folder, occluders, count, most, width, seed = sys.argv[1:]
    numbers = random.Random(int(seed) * 1_000_003 + int(occluders))
    queries = [query(i + 1, int(occluders), float(width), numbers) for i in range(int(count))]
    exact = answers(program, queries)
    open_queries = [one for one, answer in zip(queries, exact) if answer["visible"]]
    visible, found, rays = len(open_queries), [], 1
    while open_queries and rays <= int(most):
        tried = answers(program, open_queries, "--backend", "rays", "--rays", str(rays), "--seed", seed)
        found += [rays] * sum(answer["visible"] for answer in tried)
        open_queries = [one for one, answer in zip(open_queries, tried) if not answer["visible"]]
        rays *= 2
    found += [None] * len(open_queries)
    median = found[(visible - 1) // 2] if visible else None
    print(json.dumps({"visible": visible, "hidden": int(count) - visible, "median_rays": median,
                      "quartile_rays": found[3 * (visible - 1) // 4] if visible else None, "never_found": len(open_queries), "rays": found}))


if __name__ == "__main__":
    main()
