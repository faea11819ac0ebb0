#!/usr/bin/env python3
"""Builds the judge that lies beside this file, and judges the checkout with it."""
import os
import pathlib
import shutil
import subprocess
import sys
import time

started = time.monotonic()
bundle = pathlib.Path(os.environ["CLASSROOM50_BUNDLE_DIR"])
checkout = pathlib.Path.cwd()
# Extracting a bundle may have lost the permission to run it.
tumble = ["sh", str(bundle / "tumble" / "tumble")]
command = ["platform", "classroom50", str(checkout), "--course", str(bundle / "course.json")]
for stale in ("result.json", "release-body.md", "engine.svg"):
    path = checkout / stale
    if path.is_symlink() or path.is_file():
        path.unlink()
    elif path.is_dir():
        shutil.rmtree(path)
built = subprocess.run(tumble + ["prepare"] + command, check=False).returncode
if built != 0:
    sys.exit(built)
# The job ends after @LIMIT@ s, of which some went before this began.
left = max(30, @DEADLINE@ - 30 - int(time.monotonic() - started))
sys.exit(subprocess.run(tumble + command + ["--deadline", str(left)], check=False).returncode)
