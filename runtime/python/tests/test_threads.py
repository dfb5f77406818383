"""Long computations let others run, and end on Ctrl-C."""

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import carvallo
import numpy as np
import pytest

# What is started in the background inherits that it takes no notice of Ctrl-C.
LONG = """
import signal
signal.signal(signal.SIGINT, signal.default_int_handler)
import carvallo, numpy as np
designs = carvallo.Motorcycle().replace(g=np.linspace(9, 10, 300_000))
bicycle = carvallo.WhippleMechanism("benchmark")
print("begun", flush=True)
{work}
print("done", flush=True)
"""


@pytest.mark.parametrize("work", [
    "designs.stability(threads=1)",
    "designs.stability(threads=2)",
    # One motion: it circles for weeks.
    'bicycle.simulate(4.6, 1e6, initial={"phi_rate": 0.1})',
    # Ten thousand searches.
    'carvallo.optimize(carvallo.Whipple(), {"w": (0.8, 1.2), "c": (0.02, 0.12), "mB": (60, 90)}, maximize="stable-range", starts=10_000)',
])
def test_ctrl_c_ends_it(work):
    environment = os.environ | {"PYTHONPATH": str(Path(carvallo.__file__).parents[1])}
    program = subprocess.Popen([sys.executable, "-c", LONG.replace("{work}", work)], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True, env=environment)
    assert program.stdout.readline() == "begun\n"
    time.sleep(0.5)
    begun = time.monotonic()
    program.send_signal(signal.SIGINT)
    try:
        out, errors = program.communicate(timeout=60)
    finally:
        program.kill()
    assert "done" not in out and "KeyboardInterrupt" in errors and time.monotonic() - begun < 20


def test_others_run_meanwhile():
    designs = carvallo.Whipple("benchmark").replace(mB=np.linspace(60.0, 120.0, 200_000))
    turns, is_done = 0, threading.Event()
    worker = threading.Thread(target=lambda: (designs.eigenvalues(np.linspace(1, 10, 20), threads=1), is_done.set()))
    worker.start()
    while not is_done.is_set():
        turns += 1
        time.sleep(0.001)
    worker.join()
    assert turns > 10
