#!/usr/bin/python3
"""What the build writes down as the version: version_test.py CMAKE, which runs config/cmake/incision_version.cmake."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / 'config/cmake/incision_version.cmake'
CMAKE = sys.argv.pop(1)


@unittest.skipUnless(shutil.which('git'), 'needs git')
class Version(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.source = self.folder / 'source'
        self.source.mkdir()
        (self.source / 'package.xml').write_text('<package/>')

    def git(self, *words, folder=None):
        subprocess.run(['git', '-c', 'user.name=a', '-c', 'user.email=a@b', *words], cwd=folder or self.source,
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def commit(self, folder=None):
        self.git('init', folder=folder)
        self.git('add', 'package.xml', folder=self.source)
        self.git('commit', '-m', 'a', folder=folder)

    def described(self, git=shutil.which('git'), source=None):
        header = self.folder / 'description.h'
        subprocess.run([CMAKE, f'-DGIT={git}', f'-DSOURCE_FOLDER={source or self.source}', '-DFALLBACK=1.2.3',
                        f'-DHEADER={header}', '-P', SCRIPT], check=True)
        return header.read_text().split('"')[1]

    def test_it_is_the_commit(self):
        self.commit()
        self.assertRegex(self.described(), '^[0-9a-f]{7,}$')

    def test_it_tells_changes(self):
        self.commit()
        (self.source / 'package.xml').write_text('<other/>')
        self.assertRegex(self.described(), '^[0-9a-f]{7,}-dirty$')

    def test_it_is_the_tag_where_there_is_one(self):
        self.commit()
        self.git('tag', '-a', '-m', 'a', 'v2.0')
        self.assertEqual(self.described(), 'v2.0')

    def test_a_work_tree_beside_the_clone_is_one_too(self):
        self.commit()
        self.git('worktree', 'add', self.folder / 'tree')
        self.assertTrue((self.folder / 'tree/.git').is_file())
        self.assertEqual(self.described(source=self.folder / 'tree'), self.described())

    def test_without_git_it_is_the_packages_version(self):
        self.assertEqual(self.described(), '1.2.3')
        self.commit()
        self.assertEqual(self.described('GIT-NOTFOUND'), '1.2.3')
        self.assertEqual(self.described(self.folder / 'none'), '1.2.3')

    def test_the_clone_of_something_else_round_it_is_not_described(self):
        self.git('init', folder=self.folder)
        (self.folder / 'other').write_text('a')
        self.git('add', 'other', folder=self.folder)
        self.git('commit', '-m', 'a', folder=self.folder)
        self.assertEqual(self.described(), '1.2.3')

    def test_the_header_is_written_only_where_it_changes(self):
        self.commit()
        self.described()
        header = self.folder / 'description.h'
        os.utime(header, (1, 1))
        self.described()
        self.assertEqual(header.stat().st_mtime, 1)
        (self.source / 'package.xml').write_text('<other/>')
        self.described()
        self.assertGreater(header.stat().st_mtime, 1)


if __name__ == '__main__':
    unittest.main()
