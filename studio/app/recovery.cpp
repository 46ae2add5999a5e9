#include "studio/app/recovery.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>
#include <optional>

#include "core/base/files.h"
#include "core/project/project_file.h"
#include "studio/app/core_words.h"
#include "studio/app/opening.h"
#include "studio/app/session.h"

namespace kumite::studio {

namespace {

constexpr int kEditsPerAutosave = 20;
constexpr int kAutosaveMilliseconds = 30'000;

const QString kEdit = QStringLiteral(".edit");
const QString kSynced = QStringLiteral(".kumite");
const QString kLock = QStringLiteral(".lock");

QString withoutSuffix(const QString& file) {
    return file.left(file.lastIndexOf(QLatin1Char('.')));
}

/// A copy's file: one line about it, then the text of the project. Nothing for a damaged one.
std::optional<RecoveryCopy> readCopy(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
    const QJsonObject about = QJsonDocument::fromJson(file.readLine()).object();
    if (!about.contains(QStringLiteral("edits"))) return std::nullopt;
    RecoveryCopy copy;
    copy.base = withoutSuffix(path);
    copy.original = about.value(QStringLiteral("original")).toString();
    copy.name = about.value(QStringLiteral("name")).toString();
    copy.onDisk = about.value(QStringLiteral("onDisk")).toString().toStdString();
    copy.edits = about.value(QStringLiteral("edits")).toInt();
    copy.number = about.value(QStringLiteral("number")).toInt();
    copy.time =
        QDateTime::fromString(about.value(QStringLiteral("time")).toString(), Qt::ISODateWithMs);
    copy.project = file.readAll();
    try {
        parseProject(copy.project.toStdString(), path.toStdString(), toPath(Recovery::folder()));
    } catch (const std::exception&) {
        return std::nullopt;  // the other copy may be whole
    }
    return copy;
}

}  // namespace

QString Recovery::folder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
           QStringLiteral("/recovery");
}

Recovery::Recovery(Session& session, QObject* parent) : QObject(parent), session_(session) {
    QDir().mkpath(folder());
    base_ = folder() + QLatin1Char('/') + QUuid::createUuid().toString(QUuid::WithoutBraces);
    lock_ = std::make_unique<QLockFile>(base_ + kLock);
    lock_->setStaleLockTime(0);
    lock_->tryLock();
    timer_.setInterval(kAutosaveMilliseconds);
    timer_.start();
    connect(&timer_, &QTimer::timeout, this, &Recovery::autosave);
    connect(&writing_, &JobRunner::failed, this, &Recovery::report);
    connect(&session_.document(), &Document::opened, this, [this] { before_ = 0; });
    connect(&session_.document(), &Document::changed, this, &Recovery::projectChanged);
}

Recovery::~Recovery() {
    removeCopies();
    lock_->unlock();
}

QByteArray Recovery::copyText() const {
    const Document& document = session_.document();
    const QJsonObject about{
        {"original", document.path()},
        {"name", document.name()},
        {"onDisk", QString::fromStdString(document.onDisk())},
        {"edits", before_ + static_cast<int>(document.history().editsSinceSaved())},
        {"number", number_},
        {"time", QDateTime::currentDateTime().toString(Qt::ISODateWithMs)}};
    return QJsonDocument(about).toJson(QJsonDocument::Compact) + '\n' +
           QByteArray::fromStdString(projectText(document.project(), toPath(folder())));
}

void Recovery::projectChanged() {
    const Document& document = session_.document();
    if (!document.isModified()) {
        if (hasCopy_) removeCopies();
        return;
    }
    // New derived values are announced as a change, too.
    if (hasCopy_ && document.project() == copied_) return;
    ++number_;
    try {
        const QByteArray text = copyText();
        writeFileAtomically(toPath(base_ + kEdit),
                            {text.data(), static_cast<std::size_t>(text.size())},
                            Outlives::Program);
        reported_ = false;
    } catch (const std::exception& error) {
        report(coreWords(error.what()));
        return;  // the work goes on; the next edit tries again
    }
    copied_ = document.project();
    hasCopy_ = true;
    if (++sinceAutosave_ >= kEditsPerAutosave) autosave();
}

void Recovery::autosave() {
    if (sinceAutosave_ == 0 || !session_.document().isModified()) return;
    sinceAutosave_ = 0;
    writing_.start(
        tr("Saving a copy"),
        [text = copyText(), path = toPath(base_ + kSynced)](const Progress&) {
            writeFileAtomically(path, {text.data(), static_cast<std::size_t>(text.size())});
            return true;
        },
        [this](bool) {
            // It may have been saved meanwhile.
            if (!session_.document().isModified()) removeCopies();
        });
}

void Recovery::report(const QString& sentence) {
    if (!reported_) Q_EMIT failed(tr("Recovery copies cannot be written. %1").arg(sentence));
    reported_ = true;
}

void Recovery::removeCopies() {
    for (const QString& suffix : {kEdit, kSynced})
        QFile::remove(base_ + suffix);
    copied_ = {};
    hasCopy_ = false;
    sinceAutosave_ = 0;
    before_ = 0;
}

std::vector<RecoveryCopy> Recovery::leftBehind() {
    std::vector<RecoveryCopy> copies;
    QStringList bases;
    for (const QFileInfo& file :
         QDir(folder()).entryInfoList({'*' + kEdit, '*' + kSynced}, QDir::Files)) {
        bases.append(withoutSuffix(file.absoluteFilePath()));
    }
    bases.removeDuplicates();
    for (const QString& base : bases) {
        QLockFile lock(base + kLock);
        lock.setStaleLockTime(0);
        if (!lock.tryLock()) continue;
        const auto edit = readCopy(base + kEdit);
        const auto synced = readCopy(base + kSynced);
        if (edit && (!synced || synced->number <= edit->number)) {
            copies.push_back(*edit);
        } else if (synced) {
            copies.push_back(*synced);
        }
    }
    std::sort(copies.begin(), copies.end(),
              [](const RecoveryCopy& a, const RecoveryCopy& b) { return a.time > b.time; });
    return copies;
}

void Recovery::discard(const RecoveryCopy& copy) {
    for (const QString& suffix : {kEdit, kSynced, kLock})
        QFile::remove(copy.base + suffix);
}

}  // namespace kumite::studio
