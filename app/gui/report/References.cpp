// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/References.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <regex>

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

/// Whether a source names a publication: its first author, and the year of its citation as the next year of the text.
/// The other authors of a source ("Rau TS, ...") are no publications of their own.
bool isNamedIn(const std::string& source, const Publication& publication)
{
  static const std::regex aYear("\\b(19|20)[0-9][0-9]\\b");
  static const std::regex coauthor(", $"), initials("^ [A-Z]{1,3}[,( ]");
  const std::string name = publication.name, citation = publication.citation;
  std::smatch year;
  const bool hasYear = std::regex_search(citation, year, aYear);
  for (auto at = source.find(name); at != std::string::npos; at = source.find(name, at + 1)) {
    const std::string before = source.substr(0, at), after = source.substr(at + name.size());
    if (std::regex_search(before, coauthor) && std::regex_search(after, initials)) continue;
    std::smatch next;
    if (!hasYear || !std::regex_search(after, next, aYear) || next.str() == year.str()) return true;
  }
  return false;
}

/// Whether a text rests on literature that it does not name.
bool isGeneral(const std::string& source)
{
  for (const char* words : {"general literature", "clinical studies", "public research code"})
    if (source.find(words) != std::string::npos) return true;
  return false;
}

constexpr Publication known[] = {
    {"Avci", "Avci et al. 2014, J Comp Neurol 522:3245. Sections of 16 scalae tympani."},
    {"Canfarotta", "Canfarotta et al. 2021, PMC8943918. 51 flexible arrays of 31.5 mm."},
    {"nine neurotologists",
     "Clinical and Experimental Otorhinolaryngology. Speed of nine neurotologists in cadaver "
     "heads."},
    {"Dhanasingh", "Dhanasingh and Jolly 2019, PMC6712287. Scalar deviation and fold-over."},
    {"Dohr", "Dohr et al. 2021, Appl Sci 11:5162. Friction of an array on a tissue simulant."},
    {"Froehlich",
     "Froehlich et al. 2024, PLOS ONE, doi 10.1371/journal.pone.0295121. Average scala tympani of "
     "15 "
     "cochleae; insertions into its phantom."},
    {"Gabrielpillai", "Gabrielpillai et al. 2018. Fold-over of the tip in 1722 ears."},
    {"Jwair", "Jwair et al. 2021, Laryngoscope 131:1358. Translocation in 33 studies."},
    {"Kesler", "Kesler et al. 2017. Speed, rests and reversals of insertions by hand."},
    {"Knörle", "Knörle 2025. Fold-over of the tip in 129 Slim Modiolar arrays (abstract)."},
    {"Kratchman",
     "Kratchman et al. 2016, Audiol Neurotol 21:244. Force that ten otologic surgeons detect."},
    {"Kuopio", "Kuopio et al. 2024. 25 SlimJ arrays."},
    {"Kuthubutheen",
     "Kuthubutheen et al. 2019, BioMed Research International 5849871, table 2. Arrays of 28 and "
     "31 mm."},
    {"Medan", "Medan, PMC6449142. A, B and H of 36 ears."},
    {"Mirsalehi",
     "Mirsalehi et al. 2017, Eur Arch Otorhinolaryngol. Forces of insertions into ten temporal "
     "bones."},
    {"Muerbe", "Muerbe et al. 2001. Tremor in ear surgery."},
    {"O'Connell", "O'Connell et al. 2016. Scalar position of CI422 and CI512 arrays (abstract)."},
    {"O'Connell", "O'Connell et al. 2017, PMC5825186. Angles and scalar position of 48 arrays."},
    {"Pietsch",
     "Pietsch et al. 2017, Scientific Reports. Shape of 138 human cochleae: 108 casts and 30 in "
     "micro-CT."},
    {"Rau", "Rau et al. 2024, Front Neurol 15:1400455. Forces of insertions in five patients."},
    {"Salcher",
     "Salcher et al. 2019, posters at CIAP and ARO. Force curves in fresh cochleae of pigs and in "
     "channels of their shape."},
    {"Todd and Naghdy",
     "Todd and Naghdy, Real-time haptic modeling and simulation for prosthetic insertion. Forces "
     "and "
     "friction of a Contour in a synthetic scala tympani."},
    {"Wimmer", "Wimmer et al. 2019, Data in Brief 25:104782. Labels of bony lumens in micro-CT."},
    {"Clark et al.", "Clark et al. Logarithmic spiral of the cochlea.", false},
    {"Escude", "Escude et al. 2006. Length of the lateral wall from A.", false},
    {"Greenwood", "Greenwood 1990. Frequency by place on the organ of Corti.", false},
    {"Kha and Chen", "Kha and Chen 2006, J Biomech 39:1752. Friction on endosteum.", false},
    {"Kha et al.", "Kha et al. 2004. Bending moduli of a straight array.", false},
    {"Landsberger",
     "Landsberger et al. 2015. Angles of contacts, as tabulated in public research code.", false},
    {"Schurzig", "Schurzig et al. 2018. Cochlear duct length from A and B.", false},
    {"Schuster",
     "Schuster et al. 2015, Otol Neurotol 36:657. Strength of the cochlear partition, 42 to 122 "
     "mN.",
     false},
    {"Stakhovskaya", "Stakhovskaya et al. 2007. Length of the organ of Corti, n = 9.", false}};

// Outside of the class, whose texts lupdate would assign to it.
QString assumptionText() { return tr("assumption"); }
QString generalText() { return tr("general literature"); }
QString headingText() { return tr("References"); }
QString noteText()
{
  return tr(
      "Assumption: a choice, or a value whose source was not at hand in the original. The "
      "guide lists them (The method, Assumptions).");
}

}  // namespace

std::span<const Publication> publications() { return known; }

QString References::label(const std::string& source)
{
  std::vector<std::size_t> numbers;
  for (const Publication& each : known) {
    if (!each.wasRead || !isNamedIn(source, each)) continue;
    const auto found = std::find(cited_.begin(), cited_.end(), &each);
    numbers.push_back(std::size_t(found - cited_.begin()) + 1);
    if (found == cited_.end()) cited_.push_back(&each);
  }
  if (numbers.empty()) return isGeneral(source) ? generalText() : assumptionText();
  std::sort(numbers.begin(), numbers.end());
  QStringList texts;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (last < i + 2) last = i;  // two are not a range
    texts << (last == i ? QString::number(numbers[i])
                        : QStringLiteral("%1–%2").arg(numbers[i]).arg(numbers[last]));
    i = last + 1;
  }
  return QStringLiteral("[%1]").arg(texts.join(QStringLiteral(", ")));
}

QString References::list() const
{
  if (cited_.empty()) return {};
  QString rows;
  for (std::size_t i = 0; i < cited_.size(); ++i)
    rows += QStringLiteral("<tr><td class=\"quiet\">[%1]</td><td>%2</td></tr>")
                .arg(i + 1)
                .arg(QString::fromUtf8(cited_[i]->citation).toHtmlEscaped());
  return QStringLiteral("<h2>%1</h2><table cellspacing=\"0\">%2</table><p class=\"quiet\">%3</p>")
      .arg(headingText(), rows, noteText());
}

}  // namespace perilymph::gui
