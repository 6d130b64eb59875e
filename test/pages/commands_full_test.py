#!/usr/bin/python3
"""The command lines of the pages do what the pages say: those that take minutes, or Gmsh and its like.

commands_full_test.py BUILD_FOLDER
"""

import sys
import unittest

import pages
import session as sessions
from covered import Shown

WORKSPACE = Shown('README.md', 'mkdir -p ~/ws/src')
STL_TO_MESH = Shown('README.md', 'cp $(rospack find incision)')
BATCH = Shown('README.md', 'rosrun incision incision_batch organ.yaml --steps 50')
GMSH = Shown('README.md', 'sudo apt-get install gmsh')
LAUNCHED = [Shown('README.md', 'roslaunch incision dvrk.launch'),
            Shown('README.md', 'roslaunch incision scalpel.launch by_hand'),
            Shown('launch/README.md', 'roslaunch incision dvrk.launch'),
            Shown('launch/README.md', 'roslaunch incision two_arms.launch'),
            Shown('launch/README.md', 'roslaunch incision scalpel.launch'),
            Shown('launch/README.md', 'roslaunch incision paper.launch')]
DEMOS = [Shown('launch/README.md', './launch/demo.sh ' + option)
         for option in ('--headless', '--scalpel', '--two-arms', '--build-only')]
SETUP = Shown('launch/README.md', 'source build/devel/setup.bash')
LIVER = Shown('launch/README.md', 'incision_batch config/scenes/liver.yaml')
ANIMAL = Shown('launch/README.md', 'incision_batch config/scenes/animal.yaml')
ROBOT = Shown('msg/README.md', 'roslaunch incision incision.launch scene:=$PWD/my_scene.yaml')
OWN_PACKAGE = [Shown('msg/README.md', 'cd ~/ws/src && catkin_create_pkg'), Shown('msg/README.md', 'cd ~/ws\nchmod +x src/my_robot')]
SCALPEL = Shown('msg/README.md', 'roslaunch incision incision.launch scene:=$(rospack')
RECORD = Shown('msg/README.md', 'rosbag record')
STAMPED = Shown('msg/README.md', "rostopic pub -1 /incision/cut_plane incision/CutPlane '{header: auto")
SIMULATED = Shown('msg/README.md', 'rosparam set /use_sim_time true')
PLAYED = Shown('msg/README.md', 'rosbag play --clock')
BAG = Shown('msg/README.md', 'rosrun incision incision_bag')
SURFACE = Shown('config/README.md', 'cp $(rospack find incision)')
ADMESH = Shown('config/README.md', 'admesh')
MESHIO = Shown('config/README.md', 'meshio convert')
JOINED = Shown('config/README.md', 'gmsh join.geo')

# A block of 80 x 60 x 50 mm as the surface that a segmentation program would write.
STL_OF_A_BLOCK = 'SetFactory("OpenCASCADE"); Box(1) = {-0.04, -0.03, 0, 0.08, 0.06, 0.05}; Mesh.MeshSizeMax = 0.01;'


def block(page, language, containing):
    return next(block.text for block in pages.blocks(page, pages.pages()[page])
                if block.language == language and containing in block.text)


class Commands(sessions.Commands):
    def write(self, name, text):
        path = self.session.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding='utf-8')

    def test_launch_files_start_and_end_at_an_interrupt(self):
        for shown in LAUNCHED:
            for line in shown.lines():
                with self.subTest(line=line):
                    terminal = self.session.terminal(line)
                    self.session.state(20)
                    self.assertEqual(0, self.session.interrupt(terminal))
                    self.assertNotIn('has died', self.session.said(terminal))

    def test_a_robots_poses_lead_a_tool(self):
        sessions.copied(self.session, 'config/scenes/two_arms.yaml', 'my_scene.yaml')
        self.session.terminal(ROBOT.text)
        self.session.state()
        self.assertIn('/PSM1/measured_cp', self.session.run('rosnode info /incision'))
        self.assertIn('robot_base', self.session.run('rostopic echo -n1 /tf_static'))

    def test_the_demos_end_well(self):
        for shown in DEMOS:
            with self.subTest(demo=shown.text):
                # Those that stay until Ctrl-C get one.
                ended = shown.text if 'headless' in shown.text or 'only' in shown.text else \
                    f'timeout -s INT 30 {shown.text} --headless || [[ $? == 124 ]]'
                said = self.session.run(f'cd {pages.ROOT}; {ended}', 900)
                self.assertNotIn('has died', said)
        self.session.run(f'cd {pages.ROOT}; {SETUP.text}; rospack find incision')

    def test_an_stl_surface_becomes_a_body_that_is_cut(self):
        self.session.run(GMSH.text.replace('sudo apt-get install', 'apt-get install --simulate'))
        self.write('block.geo', STL_OF_A_BLOCK)
        self.session.run('gmsh -2 block.geo -format stl -o surface.stl')
        self.session.run(STL_TO_MESH.text)
        self.write('organ.yaml', block('README.md', 'yaml', 'organ.msh'))
        result = sessions.last_json(self.session.run(BATCH.text))
        self.assertEqual(1, result['cracks'])
        self.assertAlmostEqual(0.08 * 0.06 * 0.05, sum(result['piece_volumes']), delta=1e-6)
        self.write('block.geo', STL_OF_A_BLOCK + 'Mesh.ScalingFactor = 1000;')
        self.session.run('gmsh -2 block.geo -format stl -o surface.stl; rm body.msh')
        self.assertIn('is UNIT right', self.session.run(STL_TO_MESH.text + ' || echo refused'))
        self.assertFalse((self.session.folder / 'body.msh').exists())

    def test_other_formats_become_meshes(self):
        self.write('block.geo', STL_OF_A_BLOCK)
        self.session.run('gmsh -2 block.geo -format stl -o open.stl')
        self.session.run(ADMESH.text)
        self.session.run('mv closed.stl surface.stl')
        self.session.run(SURFACE.text)
        self.session.run('gmsh body.msh -save -format vtk -o in.vtk; gmsh body.msh -save -format msh1 -o old.msh')
        self.session.run(MESHIO.text)
        self.write('join.geo', 'Merge "in.msh"; Coherence Mesh;')
        self.session.run('cp body.msh in.msh')
        self.session.run(JOINED.text)
        volumes = set()
        for mesh in ('body', 'new', 'out'):
            self.write('scene.yaml', f'body: {{mesh: {mesh}.msh}}')
            result = sessions.last_json(self.session.run('incision_batch scene.yaml --steps 0'))
            volumes.add(round(sum(result['piece_volumes']), 9))
        self.assertEqual(1, len(volumes))

    def test_the_pictures_of_the_pages_can_be_drawn(self):
        (self.session.folder / 'config').symlink_to(pages.ROOT / 'config')
        (self.session.folder / 'test').symlink_to(pages.ROOT / 'test')
        for shown, picture in ((ANIMAL, 'animal.png'), (LIVER, 'liver_force.png')):
            self.session.run(shown.text, 900)
            self.assertGreater((self.session.folder / picture).stat().st_size, 10000)

    def test_a_workspace_is_built_and_a_test_of_ones_own_passes(self):
        said = self.session.run(WORKSPACE.text.replace('/path/to/incision', str(pages.ROOT)), 3000)
        self.assertEqual(100, sessions.last_json(said)['steps'])
        self.session.run(OWN_PACKAGE[0].text)
        package = self.session.folder / 'ws/src/my_robot'
        self.write('ws/src/my_robot/test/my_robot.test', block('msg/README.md', 'xml', '<launch>'))
        self.write('ws/src/my_robot/test/my_robot_test.py', block('msg/README.md', 'python', 'MyRobot'))
        with open(package / 'CMakeLists.txt', 'a', encoding='utf-8') as lists:
            lists.write(block('msg/README.md', 'cmake', 'add_rostest'))
        manifest = package / 'package.xml'
        manifest.write_text(manifest.read_text(encoding='utf-8').replace(
            '</package>', '<test_depend>rostest</test_depend></package>'), encoding='utf-8')
        said = self.session.run(OWN_PACKAGE[1].text, 3000)
        self.assertRegex(said, r'(?s)RESULT: SUCCESS')

    def test_a_node_in_python_leads_a_scalpel_and_draws_its_force(self):
        self.write('lead_scalpel.py', block('msg/README.md', 'python', "init_node('lead_scalpel')"))
        self.session.terminal(SCALPEL.text)
        self.session.state()
        self.session.run('/usr/bin/python3 lead_scalpel.py')
        self.assertGreater((self.session.folder / 'force.png').stat().st_size, 10000)

    def test_a_recorded_bag_is_put_in_order_and_played(self):
        recorder = self.session.terminal('roslaunch incision incision.launch '
                                         'scene:=$(rospack find incision)/config/scenes/bar.yaml')
        self.session.state()
        bag = self.session.terminal(RECORD.text)
        self.session.wait_for(lambda: list(self.session.folder.glob('commands*')), 'the bag')
        self.session.run('rostopic list | grep -q /incision/cut_plane; sleep 2; ' + STAMPED.text)
        self.session.interrupt(bag)
        self.session.interrupt(recorder)
        self.write('script.py', block('msg/README.md', 'python', 'import genpy'))
        self.session.run('/usr/bin/python3 script.py')
        sessions.copied(self.session, 'config/scenes/bar.yaml', 'scene.yaml')
        said = self.session.run(BAG.text)
        self.assertEqual(1, sessions.last_json(said)['bag']['cuts_applied'])
        self.session.terminal(f'roscore -p {self.session.port}')
        self.session.wait_for(lambda: self.session.lists('/rosout'), 'the master')
        self.session.terminal(SIMULATED.text)
        self.session.wait_for(lambda: self.session.lists('/incision/cut_plane'), 'the node')
        self.session.run(PLAYED.text)
        self.assertIn('status: 0', self.session.run('rostopic echo -n1 /incision/cut_report'))


if __name__ == '__main__':
    sessions.Commands.build = sys.argv.pop(1)
    unittest.main()
