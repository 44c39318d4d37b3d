"""gallery.py PROGRAM DIR HEIGHT X Y X Y ... [| X Y ...]: an art gallery from corners, as DIR/scene.obj and its region."""
import subprocess
import sys


def main():
    program, folder, height, *numbers = sys.argv[1:]
    loops, loop = [], []
    for word in [*numbers, "|"]:
        if word == "|":
            loops.append("\n".join(f"{x} {y}" for x, y in zip(loop[::2], loop[1::2])))
            loop = []
        else:
            loop.append(word)
    with open(f"{folder}/plan.txt", "w") as file:
        file.write("\n\n".join(loops) + "\n")
    sys.exit(subprocess.run([program, "generate", "gallery", f"{folder}/plan.txt", "--height", height, "-o", f"{folder}/scene.obj"]).returncode)


if __name__ == "__main__":
    main()
