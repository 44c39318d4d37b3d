"""check_proof.py PROGRAM MATRIX PROOF: has scripts/check-cover-proof, which knows no solver, check the proof of a bound; one JSON object."""
import json
import pathlib
import subprocess
import sys
import time

CHECKER = pathlib.Path(__file__).resolve().parents[2] / "scripts/check-cover-proof"


def main():
    _, matrix, proof = sys.argv[1:]
    begin = time.monotonic()
    done = subprocess.run([sys.executable, CHECKER, matrix, proof], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(json.dumps({"holds": done.returncode == 0, "says": done.stdout.strip(), "seconds": time.monotonic() - begin}))


if __name__ == "__main__":
    main()
