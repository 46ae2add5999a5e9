#pragma once

#include <QDialog>
#include <QObject>
#include <QString>

#include <vector>

#include "core/base/finding.h"

class QVBoxLayout;

namespace kumite::studio {

struct FoundInFiles {
    QString about;
    Findings findings;
};

/// What was found in the files of the open project: warnings and what is merely worth knowing.
class FindingsLog : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    void add(const QString& about, const Findings& findings);
    void clear();
    const std::vector<FoundInFiles>& groups() const { return groups_; }
    int count() const;

Q_SIGNALS:
    void changed();

private:
    std::vector<FoundInFiles> groups_;
};

/// Lists them all; stays open beside the window and follows.
class FindingsPage : public QDialog {
    Q_OBJECT

public:
    FindingsPage(const FindingsLog& findings, QWidget* parent);

private:
    void fill();

    const FindingsLog& findings_;
    QWidget* content_;
    QVBoxLayout* rows_;
};

}  // namespace kumite::studio
