#pragma once

#include <QObject>
#include <QString>

#include "core/project/agreement.h"
#include "core/project/label_files.h"
#include "studio/jobs/job_runner.h"

class QWidget;

namespace kumite::studio {

class MessageStrip;
class Session;

/// Labels and vocabularies in and out of files. What asks for a file also has a function that takes
/// one, for tests and scripts. Reading runs beside the window.
class LabelExchange : public QObject {
    Q_OBJECT

public:
    LabelExchange(Session& session, MessageStrip& messages, QWidget* window);

    void askForImport();
    /// Of a made bout its truth, which lies beside its recordings; else asks for a file.
    void takeOver();
    void askForExport();
    void askForOther();
    void askForVocabulary();

    /// Takes over the labels of a file and reports which of them found no action. Labels that name
    /// no take belong to the shown one.
    void importFrom(const QString& path);
    /// By the file's suffix; an .eaf holds the shown take, a table all takes.
    void exportTo(const QString& path);
    /// Reads another person's labels to compare them; `compared` follows.
    void compareWith(const QString& path);
    /// Says what is odd about the vocabulary and which labels it would drop, and asks.
    void useVocabulary(const QString& path);
    void useBuiltInVocabulary();

    JobRunner& jobs() { return jobs_; }

Q_SIGNALS:
    /// Another person's labels, brought to the actions of the project.
    void compared(const QString& name, const MatchedLabels& labels);

private:
    template <typename Done>
    void read(const QString& path, Done done);
    void report(const QString& path, int read, const MatchedLabels& matched,
                const Findings& findings);
    void offerVocabulary(const Vocabulary& vocabulary, const Findings& findings,
                         const QString& about);

    Session& session_;
    MessageStrip& messages_;
    QWidget* window_;
    JobRunner jobs_;
};

}  // namespace kumite::studio
