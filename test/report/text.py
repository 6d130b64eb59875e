"""Fills the report's templates.

A field is one of str.format: `{name}`, `{name[key]:.2f}`. Besides, the format `.1 %` shows a share in per cent, and a list
is shown as the cells of a table, each in the field's format; with `---` as that of its rule. What is None is a dash.
A line that begins with `@name ` stands once for each entry of a list, whose keys are fields of the line.
"""

import string


class Fields(string.Formatter):
    def format_field(self, value, format_spec):
        if isinstance(value, (list, tuple)):
            return ' | '.join(self.format_field(one, format_spec) for one in value)
        if format_spec == '---':
            return format_spec
        if value is None:
            return '–'
        if format_spec.endswith(' %'):
            return f'{100 * value:{format_spec[:-2]}f} %'
        return super().format_field(value, format_spec)


def filled(template, fields):
    """The template's text. Throws KeyError where it names a field that there is not."""
    form, lines = Fields(), []
    for line in template.split('\n'):
        if line.startswith('@'):
            name, line = line[1:].split(' ', 1)
            lines += [form.vformat(line, (), {**fields, **entry}) for entry in fields[name]]
        else:
            lines.append(form.vformat(line, (), fields))
    return '\n'.join(lines)
