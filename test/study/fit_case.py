"""A bar of a known Young's modulus that is pressed, as the program measures it, and the study to hold it against."""

import csv
import importlib.machinery
import importlib.util
import subprocess

import numpy
from study_case import SOURCE, StudyCase

FIT = SOURCE / 'launch/study/incision_fit'
PRESS = SOURCE / 'launch/study/press_study.yaml'
KEY = 'body.material.young_modulus'
COLUMNS = ('time', 'clamp_1_force_x')
TRUE = 31_234.0  # [Pa]: none of the study's values
NOISE = 5.0      # [N]: a twentieth of the force


def load():
    """The program as a module."""
    loader = importlib.machinery.SourceFileLoader('incision_fit', str(FIT))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader('incision_fit', loader))
    loader.exec_module(module)
    return module


class FitCase(StudyCase):
    def measure(self):
        """What the program says of the true tissue: times and forces."""
        listed = self.study(PRESS, '--list')[0].splitlines()[0]
        record = self.folder.parent / 'true.csv'
        subprocess.run(f'{listed.split(" --record ")[0]} --set {KEY}={TRUE} --record {record}', shell=True, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with open(record, newline='', encoding='utf-8') as file:
            return numpy.array([[float(row[c]) for c in COLUMNS] for row in csv.DictReader(file)][1:]).T

    def write_curve(self, x, y):
        text = ','.join(COLUMNS) + '\n' + ''.join(f'{a:.17g},{b:.17g}\n' for a, b in zip(x, y))
        return self.write(text, 'measured.csv')
