#include "studio/workspaces/label/label_exchange.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include <filesystem>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/project/labels.h"
#include "core/project/vocabulary_change.h"
#include "studio/app/core_words.h"
#include "studio/app/folders.h"
#include "studio/app/message_strip.h"
#include "studio/app/questions.h"
#include "studio/app/session.h"

namespace kumite::studio {

namespace {

std::filesystem::path pathOf(const QString& path) {
    return std::filesystem::path(path.toStdU16String());
}

QString nameOf(const QString& path) {
    return QFileInfo(path).fileName();
}

QString kindsToRead() {
    return LabelExchange::tr("Labels (*.csv *.json *.eaf);;All files (*)");
}

/// What came of reading a file.
struct ReadLabels {
    int read = 0;
    MatchedLabels matched;
    Findings findings;
};

}  // namespace

LabelExchange::LabelExchange(Session& session, MessageStrip& messages, QWidget* window)
    : QObject(window), session_(session), messages_(messages), window_(window) {
    connect(&jobs_, &JobRunner::failed, &messages_, &MessageStrip::showError);
}

void LabelExchange::takeOver() {
    for (const Take& take : session_.document().project().takes) {
        for (const Fighter& fighter : take.fighters) {
            const auto truth = fighter.recording.path.parent_path() / "truth.json";
            std::error_code unreadable;
            if (!std::filesystem::exists(truth, unreadable)) continue;
            importFrom(QString::fromStdString(truth.string()));
            return;
        }
    }
    askForImport();
}

void LabelExchange::askForImport() {
    const QString path = fileToOpen(window_, tr("Take over labels"),
                                    startFolder(session_.document()), kindsToRead());
    if (path.isEmpty()) return;
    rememberFolder(path);
    importFrom(path);
}

void LabelExchange::askForOther() {
    const QString path = fileToOpen(window_, tr("Compare with another person's labels"),
                                    startFolder(session_.document()), kindsToRead());
    if (path.isEmpty()) return;
    rememberFolder(path);
    compareWith(path);
}

void LabelExchange::askForVocabulary() {
    const QString path = fileToOpen(window_, tr("Use another vocabulary"),
                                    startFolder(session_.document()), tr("Vocabularies (*.json)"));
    if (path.isEmpty()) return;
    rememberFolder(path);
    useVocabulary(path);
}

void LabelExchange::askForExport() {
    const QString name = QFileInfo(session_.document().name()).completeBaseName();
    QString kind;
    QString path = fileToSave(
        window_, tr("Write labels"), startFolder(session_.document()) + QLatin1Char('/') + name,
        tr("Table (*.csv);;JSON (*.json);;ELAN, the shown take (*.eaf)"), &kind);
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) {
        path += kind.contains(QStringLiteral("*.json"))  ? QStringLiteral(".json")
                : kind.contains(QStringLiteral("*.eaf")) ? QStringLiteral(".eaf")
                                                         : QStringLiteral(".csv");
    }
    rememberFolder(path);
    exportTo(path);
}

template <typename Done>
void LabelExchange::read(const QString& path, Done done) {
    session_.whenCurrent([this, path, done = std::move(done)] {
        const Document& document = session_.document();
        jobs_.start(
            tr("Reading %1").arg(nameOf(path)),
            [path, project = document.project(), analysis = document.analysis(),
             take = session_.take()](const Progress&) {
                ReadLabels result;
                const auto labels =
                    readLabels(pathOf(path), *project.labelling.vocabulary, &result.findings);
                result.read = static_cast<int>(labels.size());
                result.matched = matchLabels(project, analysis, labels, take);
                return result;
            },
            done);
    });
}

void LabelExchange::report(const QString& path, int read, const MatchedLabels& matched,
                           const Findings& findings) {
    Findings all = findings;
    all.insert(all.end(), matched.unmatched.begin(), matched.unmatched.end());
    const QString sentence = tr("%1: %2 of %3 labels found their action.")
                                 .arg(nameOf(path))
                                 .arg(matched.matched)
                                 .arg(read);
    messages_.showFindings(sentence, all);
    Q_EMIT session_.hinted(sentence);
}

void LabelExchange::importFrom(const QString& path) {
    read(path, [this, path](ReadLabels labels) {
        const auto edit = [&](const Project& project, const Analysis& analysis) {
            MaybeEdit result = importLabels(project, analysis, labels.matched.fighters);
            if (result) result->name = "Take over labels of " + nameOf(path).toStdString();
            return result;
        };
        session_.document().apply(Document::BoundaryEdit(edit));
        report(path, labels.read, labels.matched, labels.findings);
    });
}

void LabelExchange::exportTo(const QString& path) {
    session_.whenCurrent([this, path] {
        const Document& document = session_.document();
        try {
            std::optional<int> take;
            if (QFileInfo(path).suffix().toLower() == QLatin1String("eaf")) take = session_.take();
            refuseToOverwrite(pathOf(path), recordingFiles(document.project()));
            writeLabels(document.project(), document.analysis(), take, pathOf(path));
            Q_EMIT session_.hinted(tr("Labels written to %1.").arg(nameOf(path)));
        } catch (const Error& error) {
            messages_.showError(coreWords(error.what()));
        }
    });
}

void LabelExchange::compareWith(const QString& path) {
    read(path, [this, path](ReadLabels labels) {
        report(path, labels.read, labels.matched, labels.findings);
        Q_EMIT compared(nameOf(path), labels.matched);
    });
}

void LabelExchange::useVocabulary(const QString& path) {
    try {
        const FileBytes file(pathOf(path));
        Findings findings;
        const Vocabulary vocabulary =
            parseVocabulary(file.bytes(), nameOf(path).toStdString(), &findings);
        offerVocabulary(vocabulary, findings, nameOf(path));
    } catch (const Error& error) {
        messages_.showError(coreWords(error.what()));
    }
}

void LabelExchange::useBuiltInVocabulary() {
    offerVocabulary(kickboxing(), {}, tr("The vocabulary that the studio brings"));
}

void LabelExchange::offerVocabulary(const Vocabulary& vocabulary, const Findings& findings,
                                    const QString& about) {
    Document& document = session_.document();
    QStringList lines;
    for (const Finding& finding : findings)
        lines.append(QStringLiteral("⚠ ") + coreWords(finding.text));
    const auto losses = lostBy(document.project(), vocabulary);
    if (!losses.empty())
        lines.append(
            tr("It has no word for these labels, which would be dropped (undo brings them "
               "back):"));
    for (const VocabularyLoss& loss : losses)
        lines.append(QStringLiteral("• ") + QString::fromStdString(lossText(loss)));
    const auto apply = [this, vocabulary] {
        const auto edit = [&](const Project& project) {
            return setVocabulary(project, vocabulary);
        };
        if (session_.document().apply(Document::ProjectEdit(edit)))
            Q_EMIT session_.hinted(
                tr("The vocabulary is %1 now.").arg(QString::fromStdString(vocabulary.name)));
    };
    if (lines.isEmpty()) return apply();
    auto* box = new QMessageBox(QMessageBox::Question, tr("Use another vocabulary"),
                                tr("%1: %2, %3 aspects.")
                                    .arg(about, QString::fromStdString(vocabulary.name))
                                    .arg(vocabulary.size()),
                                QMessageBox::Cancel, window_);
    box->setObjectName(QStringLiteral("vocabularyQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(lines.join(QLatin1Char('\n')));
    QPushButton* use = box->addButton(tr("Use vocabulary"), QMessageBox::AcceptRole);
    connect(use, &QPushButton::clicked, this, apply);
    box->open();
}

}  // namespace kumite::studio
