// SPDX-License-Identifier: BSD-3-Clause

// Order of what the search of Sphinx finds. The index holds only which page has a word, not how often. Who uses the program comes
// before who changes it: a definition, then the pages of the guide, then the code and its history. The numbers are choices: a page
// that has a word gets 5, one that has it in a heading 15; those of Scorer itself are Sphinx's own. A result is [page, title, anchor, description, score, file].
const groups = [
  [/^resources\/guide\/(de\/)?glossary$/, 1.0, 15],
  [/^resources\/guide\/(contributing|performance|proof|reference|decisions\/.*)$/, 0.25, 0],
  [/^resources\/guide\/de\//, 1.0, 1],
  [/^resources\/guide\//, 1.0, 4],
  [/^(modules|app|plugins|test)\/|CHANGELOG$/, 0.25, 0],
];

// eslint-disable-next-line no-unused-vars
var Scorer = {
  score: (result) => {
    const [page, , , , score] = result;
    const [, factor, bonus] = groups.find(([pattern]) => pattern.test(page)) || [null, 1.0, 2];
    return factor * score + bonus;
  },
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
