#!/usr/bin/python3
"""The tables of the pages hold what programs, launch files and the node have, and nothing else.

tables_test.py BUILD_FOLDER [CLASS]
"""

import ast
import csv
import re
import sys
import unittest
import xml.etree.ElementTree as xml

import pages
import session as sessions

# A block with some of everything that makes a topic or a number.
SCENE = f'''
body:
  grid: {{cells: [4, 1, 1], size: [0.2, 0.05, 0.05]}}
  regions: [{{box: [[0.1, -1, -1], [1, 1, 1]], material: {{young_modulus: 1.0e5}}}}]
boundary: [{{box: [[-1, -1, -1], [1.0e-6, 1, 1]]}}]
loads: [{{box: [[0.199, -1, -1], [1, 1, 1]], traction: [0, 0, -100]}}]
fracture: {{tensile_strength: 1.0e9}}
contact: {{ground: -1, obstacles: {pages.ROOT}/test/ros/room.urdf}}
tools:
  NAME: {{type: grasper, description: {pages.ROOT}/config/forceps.urdf, link: palm, joint: jaw, closed: 0.1, grip: 1,
         poses: [[0, 1, 1, 1, 0, 0, 0, 1], [9, 1, 1, 1, 0, 0, 0, 1]], jaw: [[0, 0.5], [9, 0.5]]}}
  BLADE: {{type: blade, edge: [[0, 0, 0], [0, 0, 0.1]], poses: [[0, 1, 1, 1, 0, 0, 0, 1], [9, 1, 1, 1, 0, 0, 0, 1]]}}
'''

CODE = re.compile(r'`([^`]+)`')


def page(name):
    return pages.pages()[name]


def names(cell):
    """What stands in code in a cell: several names where a row is about several."""
    return CODE.findall(cell)


def first_column(name, heading):
    return {found for row in pages.table(page(name), heading) for found in names(row[0])}


class WithoutRos(sessions.Commands):
    def setUp(self):
        super().setUp()
        (self.session.folder / 'scene.yaml').write_text(SCENE, encoding='utf-8')

    def test_columns_of_the_record(self):
        self.session.run('incision_batch scene.yaml --steps 2 --record run.csv')
        with open(self.session.folder / 'run.csv', encoding='utf-8') as record:
            columns = set(next(csv.reader(record)))
        listed = first_column('launch/README.md', '| column | meaning |')
        listed |= first_column('launch/README.md', '| JSON key | unit | meaning |')
        ordinary = {re.sub(r'(?<=obstacle_)\d+', '0', re.sub(r'_(?:x|y|z)$', '', column)) for column in columns}
        known = {name.replace('NAME', tool) for name in listed for tool in ('NAME', 'BLADE')}
        parts = {'contacts': ('contacts', 'deepest_contact')}  # of the JSON, which the record has as columns of their own
        known |= {column for columns in parts.values() for column in columns}
        self.assertEqual(set(), ordinary - known)

    def test_fields_of_snapshots(self):
        self.session.run('incision_batch scene.yaml --steps 1 --snapshot a.vtu --volume b.vtu')
        fields = set()
        for name in ('a.vtu', 'b.vtu'):
            text = (self.session.folder / name).read_bytes().split(b'<AppendedData')[0].decode()
            for kind in ('PointData', 'CellData'):
                section = re.search(f'<{kind}.*?</{kind}>', text, re.DOTALL)
                fields |= set(re.findall(r'Name="(\w+)"', section.group(0))) if section else set()
        self.assertEqual(fields, first_column('launch/README.md', '| field | unit | meaning |'))

    def test_arguments_of_the_launch_files(self):
        arguments = {launch.stem: {arg.get('name'): arg for arg in xml.parse(launch).getroot().findall('arg')}
                     for launch in (pages.ROOT / 'launch').glob('*.launch')}
        listed = first_column('launch/README.md', '| argument | default | meaning |\n|---|---|---|\n| `name`')
        parameters = {name.lstrip('~') for name in
                      first_column('msg/README.md', '| parameter | type | unit | default | range | meaning |')}
        self.assertEqual(set(arguments['incision']), listed | parameters - {'scene_folder'})
        for name, start in (('dvrk', '| `arm`'), ('two_arms', '| `by_hand`'), ('scalpel', '| `by_hand`')):
            heading = '| argument | default | meaning |\n|---|---|---|\n' + start
            text = page('launch/README.md')
            if name == 'scalpel':
                text = text[text.index('## A scalpel'):]
            listed = {found for row in pages.table(text, heading) for found in names(row[0])}
            has = {arg for arg, tag in arguments[name].items() if tag.get('value') is None}
            self.assertEqual(has, listed, name)


class InTheNode(sessions.Commands):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.shared = sessions.Session(cls.prefix)
        (cls.shared.folder / 'scene.yaml').write_text(re.sub(r',\s*(poses|jaw): \[\[.*?\]\](?=[,}])', '', SCENE), encoding='utf-8')
        cls.shared.terminal('roslaunch incision incision.launch scene:=$PWD/scene.yaml')
        cls.shared.state()

    @classmethod
    def tearDownClass(cls):
        cls.shared.close()
        super().tearDownClass()

    def info(self, kind):
        """Name -> type of the node's topics in one direction, or of its services."""
        text = self.shared.run('rosnode info /incision')
        section = re.search(rf'^{kind}: *\n(.*?)(?:\n\n|\Z)', text, re.MULTILINE | re.DOTALL).group(1)
        return dict(re.findall(r'\* (\S+)(?: \[(\S+)\])?', section))

    def listed(self, direction):
        rows = pages.table(page('msg/README.md'), '| topic | type | rate | meaning |')
        topics = {}
        for row in rows:
            if direction in re.sub('`[^`]*`', '', row[0]):
                for name, kind in zip(names(row[0]), names(row[1]) * 2):
                    topics[name.replace('~', '/incision/')] = kind.replace('…/ConfigDescription',
                                                                           'dynamic_reconfigure/ConfigDescription')
        return topics

    def test_topics_that_go_out(self):
        self.assertEqual({name: kind for name, kind in self.info('Publications').items()
                          if name != '/rosout' and '/BLADE/' not in name}, self.listed('out'))

    def test_topics_that_come_in(self):
        has = {name for name in self.info('Subscriptions') if '/BLADE/' not in name}
        self.assertEqual(has, set(self.listed('in')) - {'/clock'})

    def test_services(self):
        rows = pages.table(page('msg/README.md'), '| service | type | meaning |')
        for row in rows:
            name, kind = names(row[0])[0].replace('~', '/incision/'), names(row[1])[0]
            self.assertEqual(kind, self.shared.run(f'rosservice type {name}').strip())
        self.assertEqual(set(self.info('Services')) - {'/incision/get_loggers', '/incision/set_logger_level'},
                         {names(row[0])[0].replace('~', '/incision/') for row in rows})

    def test_what_may_be_set_while_it_runs(self):
        rows = pages.table(page('msg/README.md'), '| name | type | unit | at the start | range | meaning |')
        listed = {name for row in rows for name in names(row[0])}
        said = self.shared.run('rosrun dynamic_reconfigure dynparam get /incision')
        self.assertEqual(set(ast.literal_eval(said)) - {'groups'}, listed)

    def test_defaults_of_parameters(self):
        defaults = {}
        for row in pages.table(page('msg/README.md'), '| parameter | type | unit | default | range | meaning |'):
            if re.fullmatch(r'[\d.]+|`\w+`', row[3]):
                defaults[names(row[0])[0].lstrip('~')] = row[3].strip('`')
        launch = xml.parse(pages.ROOT / 'launch/incision.launch').getroot()
        self.assertEqual(defaults, {arg.get('name'): arg.get('default') for arg in launch.findall('arg')
                                    if arg.get('name') in defaults})
        self.assertGreater(len(defaults), 4)


if __name__ == '__main__':
    sessions.Commands.build = sys.argv.pop(1)
    unittest.main()
