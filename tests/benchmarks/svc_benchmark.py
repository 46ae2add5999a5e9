"""Times scikit-learn's SVC on what `kumite-label-benchmark --matrix FOLDER` wrote: the same rows,
labels, C, gamma and class weights; standardising, learning every aspect and predicting every action
are all timed, as in our own round. The seconds of processor go into FOLDER/svc.txt, too, for
`kumite-label-benchmark --peer FOLDER`. Debian: python3-sklearn."""

import sys
import time
from pathlib import Path

import numpy
import sklearn
from sklearn.svm import SVC

folder = Path(sys.argv[1])
c, gamma = map(float, (folder / "parameters.txt").read_text().split())


def rows(name):
    return numpy.fromfile(folder / name, dtype=numpy.float32).reshape(-1, 540)


actions = rows("actions.f32")
measured = [sklearn.__version__]
for count in (150, 1000):
    examples = rows(f"examples-{count}.f32")
    labels = numpy.loadtxt(folder / f"labels-{count}.txt", dtype=int)
    wall, used = time.perf_counter(), time.process_time()
    mean, deviation = examples.mean(axis=0), examples.std(axis=0)
    scale = numpy.where(deviation > 1e-6, 1 / numpy.maximum(deviation, 1e-6), 0)
    train, everything = (examples - mean) * scale, (actions - mean) * scale
    for aspect in range(labels.shape[1]):
        if len(set(labels[:, aspect])) > 1:
            machine = SVC(C=c, gamma=gamma, class_weight="balanced")
            machine.fit(train, labels[:, aspect]).predict(everything)
    wall, used = time.perf_counter() - wall, time.process_time() - used
    measured.append(f"{count} {used:.3f}")
    print(
        f"{count} examples and their mirror images, {len(actions)} actions: "
        f"{wall:.2f} s, {used:.2f} s of processor"
    )
(folder / "svc.txt").write_text("\n".join(measured) + "\n")
