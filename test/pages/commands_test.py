#!/usr/bin/python3
"""The command lines of the pages do what the pages say: those that take seconds. The others are in commands_full_test.

commands_test.py BUILD_FOLDER [CLASS]
"""

import re
import sys
import unittest

import commands_full_test  # noqa: F401, what it covers counts below
import covered
import pages
import session as sessions
from covered import Shown

# A study has a test of its own, which takes the command lines out of its page. These run all tests, so they do not run
# within one.
ELSEWHERE = {'launch/study/README.md'}
RUNS_TESTS = ('./test/run.sh', './test/benchmark/run.sh', './test/report/run.sh', 'ctest ')

PACKAGES = Shown('README.md', 'sudo apt-get install $(')
WORKSPACE = Shown('README.md', 'mkdir -p ~/ws/src')
TESTING = Shown('msg/README.md', 'sudo apt-get install python3-rostest')
NODE = Shown('README.md', 'roslaunch incision incision.launch scene:=$(rospack')
PLANE = Shown('README.md', 'rostopic pub -1')
BATCH = Shown('README.md', 'rosrun incision incision_batch organ.yaml --steps 50')
SET = Shown('README.md', 'rosrun incision incision_batch organ.yaml --steps 200')
OWN_NODE = Shown('README.md', 'roslaunch incision incision.launch scene:=$PWD/organ.yaml')
SLIT = Shown('msg/README.md', 'rosservice call /incision/reset')
LIVE = Shown('msg/README.md', "rosservice call /incision/set_parameters '{config: {doubles")
STRESS = Shown('msg/README.md', "rosservice call /incision/set_parameters '{config: {strs")
RESTORED = Shown('msg/README.md', 'roslaunch incision incision.launch checkpoint_folder')


class Coverage(unittest.TestCase):
    def test_every_command_line_is_run(self):
        missing, idle = covered.left_out()
        missing = [block for block in missing if block.page not in ELSEWHERE and not block.text.startswith(RUNS_TESTS)
                   and block.text.partition(' ')[0] != './launch/demo.sh']
        self.assertEqual(([], []), (missing, idle))


class WithoutRos(sessions.Commands):
    def test_the_packages_can_be_had(self):
        self.session.run(f'cd {pages.ROOT}; ' + PACKAGES.text.replace('sudo apt-get install', 'apt-get install --simulate'))
        self.session.run(TESTING.text.replace('sudo apt-get install', 'apt-get install --simulate'))

    def test_the_bar_runs_in_a_workspace(self):
        lines = WORKSPACE.text.replace('/path/to/incision', str(pages.ROOT)).splitlines()
        lines[1] = f'ln -s {self.prefix} devel'  # what catkin_make would have made
        said = self.session.run('\n'.join(lines))
        self.assertEqual(100, sessions.last_json(said)['steps'])


class InTheNode(sessions.Commands):
    def test_a_message_cuts_the_bar(self):
        self.session.terminal(NODE.text)
        self.session.state()
        said = self.session.run(PLANE.text)
        self.assertIn('status: 0', said)
        self.assertIn('pieces: 2', said)
        self.session.run(SLIT.text)
        said = self.session.run('rostopic echo -n1 /incision/cut_report')
        self.assertIn('label: "slit"', said)
        self.assertIn('pieces: 1', said)
        self.assertIn('value: "stress"', self.session.run(STRESS.text))
        for line in LIVE.lines():
            said = self.session.run(line)
            self.assertTrue('-1.62' in said or 'dynparam' in line, said)


class OwnOrgan(sessions.Commands):
    def test_an_organ_runs_without_ros_and_in_the_node(self):
        scene = next(block for block in pages.blocks('README.md', pages.pages()['README.md']) if block.language == 'yaml')
        (self.session.folder / 'organ.yaml').write_text(scene.text, encoding='utf-8')
        sessions.copied(self.session, 'config/meshes/organ.msh')
        self.session.run(BATCH.text)
        self.assertTrue((self.session.folder / 'cut.vtu').is_file())
        self.session.run(SET.text.replace('200', '20'))
        self.assertEqual(21, len((self.session.folder / 'run.csv').read_text(encoding='utf-8').splitlines()))
        self.session.terminal(OWN_NODE.text)
        self.session.state()
        shown = self.session.folder / 'rviz.log'
        self.session.wait_for(shown.exists, 'rviz')


class Checkpoints(sessions.Commands):
    def test_a_node_goes_on_where_it_was_killed(self):
        text = RESTORED.text.replace('/var/tmp/liver', str(self.session.folder / 'saved')).replace('autosave:=10', 'autosave:=0.1')
        first = self.session.terminal(text)
        self.session.state(50)
        self.session.wait_for(lambda: list(self.session.folder.glob('saved/autosave_*.state')), 'a checkpoint')
        self.session.interrupt(first)
        second = self.session.terminal(text)
        went_on = r"goes on from the checkpoint 'autosave_[12]' at step [1-9]"
        self.session.wait_for(lambda: re.search(went_on, self.session.said(second)), 'the node that goes on')


if __name__ == '__main__':
    sessions.Commands.build = sys.argv.pop(1)
    unittest.main()
