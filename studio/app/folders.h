#pragma once

#include <QString>

namespace kumite::studio {

class Document;

/// Where a dialog for a file begins: beside the project; where it has no file yet, beside its
/// recordings (not in the demo bout's own folder), else where a file was chosen last, else among
/// the user's documents.
QString startFolder(const Document& document);
/// Where a file was chosen is where the next dialog begins.
void rememberFolder(const QString& file);

}  // namespace kumite::studio
