#!/usr/bin/python3
"""What the pages promise of themselves: links that lead somewhere, a first page that is short, one kind of block each."""

import pathlib
import unittest

import pages

LANGUAGES = {'sh', 'yaml', 'xml', 'python', 'cmake', 'cpp'}
LINES_OF_THE_FIRST_PAGE = 160
WIDTH = 120  # of a line of text; tables and addresses may be wider


class Pages(unittest.TestCase):
    def test_links_lead_to_files_and_headings(self):
        texts = pages.pages()
        for page, text in texts.items():
            for link in pages.links(text):
                path, _, anchor = link.partition('#')
                target = (pages.ROOT / page).parent / path if path else pages.ROOT / page
                with self.subTest(page=page, link=link):
                    self.assertTrue(target.exists())
                    if anchor:
                        self.assertIn(anchor, pages.anchors(target.read_text(encoding='utf-8')))

    def test_the_first_page_is_short(self):
        lines = (pages.ROOT / 'README.md').read_text(encoding='utf-8').splitlines()
        self.assertLessEqual(len(lines), LINES_OF_THE_FIRST_PAGE)
        screen = '\n'.join(lines[:40])
        for part in ('![', '| it can | it cannot', 'one step takes', './launch/demo.sh'):
            self.assertIn(part, screen)

    def test_every_page_is_reached_from_the_first(self):
        texts = pages.pages()
        reached, new = set(), {'README.md'}
        while new:
            reached |= new
            there = {str((pages.ROOT / page).parent.joinpath(link.partition('#')[0]).resolve().relative_to(pages.ROOT))
                     for page in new for link in pages.links(texts[page]) if link.partition('#')[0].endswith('.md')}
            new = (there & set(texts)) - reached
        self.assertEqual(set(texts), reached)

    def test_blocks_say_what_they_are_in(self):
        for page, text in pages.pages().items():
            for block in pages.blocks(page, text):
                with self.subTest(block=block):
                    self.assertIn(block.language, LANGUAGES)

    def test_lines_are_not_too_wide(self):
        for page, text in pages.pages().items():
            for line in pages.prose(text).splitlines():
                if not line.startswith('|') and '](' not in line:
                    self.assertLessEqual(len(line), WIDTH, f'{page}: {line}')

    def test_files_that_a_page_names_are_there(self):
        for page, text in pages.pages().items():
            for name in pages.FILE.findall(text):
                with self.subTest(page=page, file=name):
                    self.assertTrue(any(pages.ROOT.glob(name)))


if __name__ == '__main__':
    unittest.main()
