// What the import dialog does; import_dialog_layout.cpp is how it is laid out.

#include "studio/app/import/import_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QTabWidget>

#include <numbers>

#include "core/base/text.h"
#include "studio/app/core_words.h"
#include "studio/app/import/import_preview.h"
#include "studio/app/import/role_table.h"
#include "studio/app/questions.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

/// Nothing for an empty field; false where there is no number in it.
bool numberIn(const QLineEdit* field, std::optional<double>& value) {
    const std::string text = field->text().toStdString();
    if (trimmed(text).empty()) return true;
    value = parseNumber(trimmed(text));
    return value.has_value();
}

/// "120:900", ":900", "120:" → half-open frames; an open end is -1.
std::optional<FrameRange> framesIn(const QString& text) {
    const std::string plain = text.toStdString();
    const auto parts = split(plain, ':');
    if (parts.size() != 2) return std::nullopt;
    FrameRange range{0, -1};
    if (const auto begin = trimmed(parts[0]); !begin.empty()) {
        const auto value = parseInteger(begin);
        if (!value || *value < 0) return std::nullopt;
        range.begin = *value;
    }
    if (const auto end = trimmed(parts[1]); !end.empty()) {
        const auto value = parseInteger(end);
        if (!value || *value <= range.begin) return std::nullopt;
        range.end = *value;
    }
    return range;
}

bool isAmc(const QString& file) {
    return file.endsWith(QStringLiteral(".amc"), Qt::CaseInsensitive);
}

/// Swaps two fields' texts without asking anybody.
void swapTexts(QLineEdit* a, QLineEdit* b) {
    const QSignalBlocker quietA(a), quietB(b);
    const QString first = a->text();
    a->setText(b->text());
    b->setText(first);
}

void swapChoices(QComboBox* a, QComboBox* b) {
    const QSignalBlocker quietA(a), quietB(b);
    const int first = a->currentIndex();
    a->setCurrentIndex(b->currentIndex());
    b->setCurrentIndex(first);
}

}  // namespace

ImportDialog::ImportDialog(const QStringList& files, const QString& project, QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(tr("Open recordings"));
    setAcceptDrops(true);
    layOut(project);
    soon_.setSingleShot(true);
    soon_.setInterval(150);
    connect(&soon_, &QTimer::timeout, this, &ImportDialog::look);
    connect(&reading_, &JobRunner::failed, this, &ImportDialog::showProblem);
    connect(&looking_, &JobRunner::failed, this, &ImportDialog::showProblem);
    connect(&reading_, &JobRunner::finished, this, [this] {
        if (!look_) showProblem(tr("Not read. Choose the file again to read it."));
    });
    setFiles(files);
}

bool ImportDialog::addsToProject() const {
    return !add_->isHidden() && add_->isChecked();
}

bool ImportDialog::isBusy() const {
    return reading_.isRunning() || looking_.isRunning() || soon_.isActive();
}

void ImportDialog::chooseFile(QLineEdit* field, const QString& filter) {
    const QString path =
        fileToOpen(this, tr("Choose a recording"), QFileInfo(field->text()).absolutePath(), filter);
    if (path.isEmpty()) return;
    field->setText(path);
    readFiles();
}

void ImportDialog::setFiles(const QStringList& files) {
    for (int player = 0; player < 2 && player < files.size(); ++player) {
        answers_[player].file->setText(files[player]);
        roles_->forget(player);
    }
    readFiles();
}

void ImportDialog::swapFighters() {
    Answers& a = answers_[0];
    Answers& b = answers_[1];
    for (auto field : {&Answers::file, &Answers::asf, &Answers::offset, &Answers::x, &Answers::z,
                       &Answers::yaw, &Answers::floor}) {
        swapTexts(a.*field, b.*field);
    }
    swapChoices(a.units, b.units);
    swapChoices(a.up, b.up);
    const QString roots[2] = {a.root->currentText(), b.root->currentText()};
    roles_->swapFighters();
    offerRoots();
    a.root->setCurrentText(roots[1]);
    b.root->setCurrentText(roots[0]);
    look();
}

void ImportDialog::readFiles() {
    look_.reset();
    looksOld_ = true;
    open_->setEnabled(false);
    for (QWidget* widget : asfRow_)
        widget->setVisible(isAmc(answers_[0].file->text()) || isAmc(answers_[1].file->text()));
    for (const Answers& answers : answers_)
        answers.asf->setEnabled(isAmc(answers.file->text()));
    const QString first = answers_[0].file->text().trimmed();
    name_->setPlaceholderText(QFileInfo(first).completeBaseName());
    TakeRequest request;
    QString problem;
    if (!ask(request, problem)) {
        reading_.cancel();
        showProblem(first.isEmpty() ? QString() : problem);
        return;
    }
    std::vector<RecordingKey> wanted;
    for (const RecordingKey& key : recordingsOf(request)) {
        const auto known = recordings_.find(key);
        if (known == recordings_.end() || !known->second.recording) wanted.push_back(key);
    }
    if (wanted.empty()) {
        offerRoots();
        look();
        return;
    }
    findings_->setText({});
    preview_->setLook(nullptr, tr("Reading…"));
    reading_.start(
        tr("Reading"),
        [wanted](const Progress& progress) { return readRecordings(wanted, progress); },
        [this](Recordings read) {
            for (auto& [key, result] : read)
                recordings_[key] = std::move(result);
            offerRoots();
            look();
        });
}

void ImportDialog::offerRoots() {
    bool several = false;
    for (Answers& answers : answers_) {
        const std::string asf = trimmed(answers.asf->text().toStdString()).empty()
                                    ? std::string()
                                    : answers.asf->text().trimmed().toStdString();
        const auto found = recordings_.find(
            {toPath(answers.file->text().trimmed()),
             asf.empty() ? std::filesystem::path() : toPath(QString::fromStdString(asf))});
        QStringList names;
        if (found != recordings_.end() && found->second.recording) {
            for (const std::string& name : rootNames(*found->second.recording))
                names.append(QString::fromStdString(name));
        }
        const QSignalBlocker quiet(answers.root);
        const QString chosen = answers.root->currentText();
        answers.root->clear();
        answers.root->addItems(names);
        if (names.contains(chosen)) answers.root->setCurrentText(chosen);
        answers.root->setEnabled(names.size() > 1);
        several = several || names.size() > 1;
    }
    for (QWidget* widget : rootRow_)
        widget->setVisible(several);
}

bool ImportDialog::askFighter(int player, FighterRequest& fighter, QString& problem) const {
    const Answers& answers = answers_[player];
    fighter.path = toPath(answers.file->text().trimmed());
    if (isAmc(answers.file->text()) && !answers.asf->text().trimmed().isEmpty()) {
        fighter.asf = toPath(answers.asf->text().trimmed());
    }
    if (answers.root->count() > 1) fighter.root = answers.root->currentText().toStdString();
    fighter.metresPerUnit =
        metresPerUnitFromName(answers.units->currentData().toString().toStdString());
    if (answers.up->currentIndex() > 0) {
        fighter.up = answers.up->currentIndex() == 1 ? UpAxis::Y : UpAxis::Z;
    }
    fighter.roles = roles_->mended(player);
    std::optional<double> offset, x, z, yaw;
    if (!numberIn(answers.offset, offset) || !numberIn(answers.x, x) || !numberIn(answers.z, z) ||
        !numberIn(answers.yaw, yaw) || !numberIn(answers.floor, fighter.floor)) {
        problem = tr("Start, place and floor of %1 must be numbers, such as 0.25.")
                      .arg(fighterText(player));
        return false;
    }
    fighter.offset = offset.value_or(0);
    fighter.placement = {x.value_or(0), z.value_or(0), yaw.value_or(0) * std::numbers::pi / 180};
    return true;
}

bool ImportDialog::ask(TakeRequest& request, QString& problem) const {
    if (answers_[0].file->text().trimmed().isEmpty()) {
        problem = tr("Choose a recording for fighter 1.");
        return false;
    }
    request = {};
    for (int player = 0; player < 2; ++player) {
        if (answers_[player].file->text().trimmed().isEmpty()) continue;
        if (!askFighter(player, request.fighters.emplace_back(), problem)) return false;
    }
    request.name = name_->text().trimmed().toStdString();
    if (!numberIn(rate_, request.rate) || (request.rate && !(*request.rate > 0))) {
        problem = tr("The rate must be a positive number of frames per second, such as 60.");
        return false;
    }
    if (!frames_->text().trimmed().isEmpty()) {
        request.trim = framesIn(frames_->text().trimmed());
        if (!request.trim) {
            problem = tr("Frames read begin:end, such as 120:900; either may be left out.");
            return false;
        }
    }
    return true;
}

void ImportDialog::look() {
    soon_.stop();
    looksOld_ = true;
    TakeRequest request;
    QString problem;
    if (reading_.isRunning()) return;
    if (!ask(request, problem)) {
        showProblem(problem);
        return;
    }
    for (const RecordingKey& key : recordingsOf(request)) {
        const auto found = recordings_.find(key);
        if (found == recordings_.end()) return;
        if (!found->second.recording) {
            showProblem(coreWords(found->second.error));
            return;
        }
    }
    looking_.start(
        tr("Looking"),
        [request, known = recordings_](const Progress& progress) {
            return std::make_shared<const ImportLook>(lookAt(request, known, progress));
        },
        [this, request](std::shared_ptr<const ImportLook> look) {
            request_ = request;
            looksOld_ = false;
            showLook(std::move(look));
        });
}

void ImportDialog::showLook(std::shared_ptr<const ImportLook> look) {
    look_ = std::move(look);
    preview_->setLook(look_);
    play_->setEnabled(true);
    roles_->setLook(*look_);
    tabs_->setTabText(
        1, roles_->missing() > 0 ? tr("Roles, %1 missing").arg(roles_->missing()) : tr("Roles"));
    open_->setEnabled(true);
    showFound(*look_);
    QStringList lines;
    const Colours& c = coloursFor(palette());
    for (const Severity severity : {Severity::Warning, Severity::Note}) {
        for (const Finding& finding : look_->imported.findings) {
            if (finding.severity != severity) continue;
            const QString text = coreWords(finding.text).toHtmlEscaped();
            lines.append(severity == Severity::Warning
                             ? tr("<b>Check:</b> %1").arg(text)
                             : QStringLiteral("<span style='color:%1'>%2</span>")
                                   .arg(c.secondText.name(), text));
        }
    }
    findings_->setText(lines.join(QStringLiteral("<br>")));
}

void ImportDialog::showFound(const ImportLook& look) {
    QStringList rates;
    QStringList frames;
    const auto& fighters = look.imported.take.fighters;
    for (std::size_t player = 0; player < fighters.size(); ++player) {
        const Survey& survey = look.imported.surveys[player];
        Answers& answers = answers_[player];
        answers.units->setItemText(0,
                                   tr("%1 (found)").arg(QString::fromStdString(survey.unitName)));
        answers.up->setItemText(
            0, tr("%1 (found)").arg(survey.space.up == UpAxis::Y ? tr("y") : tr("z")));
        if (answers.units->currentIndex() > 0) answers.units->setItemText(0, tr("as found"));
        if (answers.up->currentIndex() > 0) answers.up->setItemText(0, tr("as found"));
        const Motion& motion = *fighters[player].motion;
        rates.append(QString::number(rateOf(motion.frameTime)));
        frames.append(tr("%1:%2 of %3")
                          .arg(fighters[player].frames.begin)
                          .arg(fighters[player].frames.end)
                          .arg(motion.frameCount));
    }
    rates.removeDuplicates();
    frames.removeDuplicates();
    rateFound_->setText(tr("Hz; header: %1").arg(rates.join(tr(" and "))));
    framesFound_->setText(frames.join(tr(" and ")));
}

void ImportDialog::showProblem(const QString& problem) {
    look_.reset();
    open_->setEnabled(false);
    play_->setEnabled(false);
    preview_->setLook(nullptr);
    findings_->setText(problem.toHtmlEscaped());
    rateFound_->setText(tr("Hz"));
    framesFound_->setText(tr("begin:end"));
}

void ImportDialog::accept() {
    // What is opened is what was looked at; an answer given just now is looked at first.
    if (look_ && !looksOld_) {
        QDialog::accept();
    } else if (!isBusy()) {
        look();
    }
}

void ImportDialog::dragEnterEvent(QDragEnterEvent* event) {
    const auto urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.size() <= 2 && urls.front().isLocalFile()) {
        event->acceptProposedAction();
    }
}

void ImportDialog::dropEvent(QDropEvent* event) {
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls())
        files.append(url.toLocalFile());
    event->acceptProposedAction();
    // One file goes to the fighter whose row it falls on, else to the one that has none.
    const QPoint at = event->position().toPoint();
    const QLineEdit* second = answers_[1].file;
    const bool onSecond = second->geometry().contains(second->parentWidget()->mapFrom(this, at));
    const bool onFirst =
        answers_[0].file->geometry().contains(answers_[0].file->parentWidget()->mapFrom(this, at));
    const bool firstTaken = !answers_[0].file->text().isEmpty() && second->text().isEmpty();
    if (files.size() == 1 && (onSecond || (firstTaken && !onFirst))) {
        files.prepend(answers_[0].file->text());
    }
    setFiles(files);
}

}  // namespace kumite::studio
