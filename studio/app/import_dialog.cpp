#include "studio/app/import_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <numbers>

#include "core/base/text.h"
#include "studio/app/opening.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

std::optional<double> numberIn(const QLineEdit* field) {
    return parseNumber(trimmed(field->text().toStdString()));
}

QWidget* inRow(std::initializer_list<QWidget*> widgets) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    for (QWidget* widget : widgets)
        layout->addWidget(widget);
    layout->addStretch(1);
    return row;
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

}  // namespace

ImportDialog::ImportDialog(const QStringList& files, const QString& project, QWidget* parent)
    : QDialog(parent),
      files_{new QLineEdit(this), new QLineEdit(this)},
      name_(new QLineEdit(this)),
      units_(new QComboBox(this)),
      up_(new QComboBox(this)),
      add_(new QCheckBox(this)),
      problem_(new QLabel(this)) {
    setWindowTitle(tr("Open recordings"));
    setMinimumWidth(560);
    auto* form = new QFormLayout(this);
    form->setContentsMargins(16, 16, 16, 16);
    form->setVerticalSpacing(8);
    form->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    for (int player = 0; player < 2; ++player) {
        if (player < files.size()) files_[player]->setText(files[player]);
        form->addRow(tr("Fighter %1").arg(player + 1), fileRow(files_[player], player));
    }
    files_[1]->setPlaceholderText(tr("none: a single fighter"));
    auto* swap = new QPushButton(tr("Swap fighters"), this);
    connect(swap, &QPushButton::clicked, this, &ImportDialog::swapFiles);
    form->addRow(QString(), inRow({swap}));
    name_->setAccessibleName(tr("Take name"));
    if (!files.isEmpty()) name_->setPlaceholderText(QFileInfo(files.front()).completeBaseName());
    form->addRow(tr("Take"), name_);

    rate_ = number(tr("Rate in Hz"), tr("as the files say"));
    form->addRow(tr("Rate"), inRow({rate_, new QLabel(tr("Hz"))}));
    frames_ = number(tr("Frames, begin:end"), tr("found"));
    frames_->setToolTip(
        tr("begin:end in frames of the file; end is the first frame left out. "
           "Empty: all, without a leading T-pose."));
    form->addRow(tr("Frames"), inRow({frames_, new QLabel(tr("begin:end"))}));
    units_->setAccessibleName(tr("Unit of length"));
    units_->addItem(tr("found"), QString());
    for (const char* unit : {"m", "dm", "cm", "mm", "inch", "foot", "cmu"}) {
        units_->addItem(QLatin1String(unit), QLatin1String(unit));
    }
    up_->setAccessibleName(tr("Up axis"));
    up_->addItem(tr("found"));
    up_->addItem(QStringLiteral("y"));
    up_->addItem(QStringLiteral("z"));
    form->addRow(tr("Unit"), inRow({units_, new QLabel(tr("up axis")), up_}));
    offset_ = number(tr("Offset of fighter 2 in seconds"), QStringLiteral("0"));
    form->addRow(tr("Fighter 2 starts at"), inRow({offset_, new QLabel(tr("s"))}));
    x_ = number(tr("Fighter 2: x in metres"), QStringLiteral("0"));
    z_ = number(tr("Fighter 2: z in metres"), QStringLiteral("0"));
    yaw_ = number(tr("Fighter 2: turn in degrees"), QStringLiteral("0"));
    form->addRow(tr("Fighter 2 stands at"),
                 inRow({new QLabel(tr("x")), x_, new QLabel(tr("m   z")), z_,
                        new QLabel(tr("m   turned")), yaw_, new QLabel(tr("°"))}));
    add_->setText(tr("Add as a take to %1").arg(project));
    add_->setChecked(!project.isEmpty());
    add_->setVisible(!project.isEmpty());
    form->addRow(QString(), add_);
    problem_->setWordWrap(true);
    problem_->hide();
    form->addRow(problem_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    auto* open = buttons->addButton(tr("Open bout"), QDialogButtonBox::AcceptRole);
    open->setProperty("role", "step");
    open->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(buttons);
    open->setFocus();
}

QWidget* ImportDialog::fileRow(QLineEdit* field, int player) {
    auto* choose = new QPushButton(tr("Choose…"), this);
    choose->setAccessibleName(tr("Choose the recording of %1").arg(fighterText(player)));
    field->setAccessibleName(tr("Recording of %1").arg(fighterText(player)));
    field->setMinimumWidth(320);
    connect(choose, &QPushButton::clicked, this, [this, field] {
        const QString path = QFileDialog::getOpenFileName(
            this, tr("Choose a recording"), QFileInfo(field->text()).absolutePath(),
            tr("Recordings (*.bvh *.BVH *.amc *.AMC);;All files (*)"));
        if (!path.isEmpty()) field->setText(path);
    });
    auto* row = inRow({field, choose});
    static_cast<QHBoxLayout*>(row->layout())->setStretch(0, 1);
    return row;
}

QLineEdit* ImportDialog::number(const QString& accessibleName, const QString& hint) {
    auto* field = new QLineEdit(this);
    field->setAccessibleName(accessibleName);
    field->setPlaceholderText(hint);
    field->setFixedWidth(QFontMetrics(font()).horizontalAdvance(tr("as the files say")) + 24);
    if (hint == QStringLiteral("0")) field->setFixedWidth(64);
    return field;
}

void ImportDialog::swapFiles() {
    const QString first = files_[0]->text();
    files_[0]->setText(files_[1]->text());
    files_[1]->setText(first);
}

bool ImportDialog::addsToProject() const {
    return !add_->isHidden() && add_->isChecked();
}

bool ImportDialog::read(TakeRequest& request, QString& problem) const {
    QStringList chosen;
    for (const QLineEdit* field : files_) {
        if (!field->text().trimmed().isEmpty()) chosen.append(field->text().trimmed());
    }
    if (chosen.isEmpty()) {
        problem = tr("Choose a recording for fighter 1.");
        return false;
    }
    request = requestFor(chosen);
    request.name = name_->text().trimmed().toStdString();
    if (!rate_->text().trimmed().isEmpty()) {
        request.rate = numberIn(rate_);
        if (!request.rate || *request.rate <= 0) {
            problem = tr("The rate must be a positive number of frames per second, such as 60.");
            return false;
        }
    }
    if (!frames_->text().trimmed().isEmpty()) {
        request.trim = framesIn(frames_->text().trimmed());
        if (!request.trim) {
            problem = tr("Frames read begin:end, such as 120:900; either may be left out.");
            return false;
        }
    }
    for (FighterRequest& fighter : request.fighters) {
        fighter.metresPerUnit =
            metresPerUnitFromName(units_->currentData().toString().toStdString());
        if (up_->currentIndex() > 0) fighter.up = up_->currentIndex() == 1 ? UpAxis::Y : UpAxis::Z;
    }
    if (request.fighters.size() < 2) return true;
    FighterRequest& second = request.fighters[1];
    const auto put = [&](const QLineEdit* field, double& value) {
        if (field->text().trimmed().isEmpty()) return true;
        const auto given = numberIn(field);
        if (given) value = *given;
        return given.has_value();
    };
    if (!put(offset_, second.offset) || !put(x_, second.placement.x) ||
        !put(z_, second.placement.z) || !put(yaw_, second.placement.yaw)) {
        problem = tr("Start and place of fighter 2 must be numbers, such as 0.25.");
        return false;
    }
    second.placement.yaw *= std::numbers::pi / 180;
    return true;
}

void ImportDialog::accept() {
    QString problem;
    if (read(request_, problem)) {
        QDialog::accept();
        return;
    }
    problem_->setText(problem);
    problem_->show();
}

}  // namespace kumite::studio
