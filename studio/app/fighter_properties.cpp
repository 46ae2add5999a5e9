#include "studio/app/fighter_properties.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include <cmath>
#include <numbers>

#include "core/project/edits.h"
#include "core/project/project_file.h"
#include "studio/app/body_models.h"
#include "studio/app/comfort.h"
#include "studio/app/commands.h"
#include "studio/app/core_words.h"
#include "studio/app/language.h"
#include "studio/app/opening.h"
#include "studio/app/panel_parts.h"
#include "studio/app/questions.h"
#include "studio/app/session.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

QLabel* headingOf(const QString& text, QWidget* parent) {
    auto* label = headingLabel(text, parent);
    label->setContentsMargins(0, 8, 0, 0);
    return label;
}

}  // namespace

FighterProperties::FighterProperties(Session& session, const CommandTable& commands,
                                     QWidget* parent)
    : QDialog(parent),
      session_(session),
      who_(new QComboBox(this)),
      recording_(new QLabel(this)),
      content_(new QWidget(this)) {
    setWindowTitle(tr("Fighter properties"));
    // The edits of this window are undone with its keys, too.
    addAction(commands.action(QStringLiteral("edit.undo")));
    addAction(commands.action(QStringLiteral("edit.redo")));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 8, 12);
    layout->setSpacing(8);
    who_->setAccessibleName(tr("Fighter"));
    who_->setToolTip(tr("Whose properties are shown: the active fighter's (Tab)"));
    layout->addWidget(who_);
    recording_->setProperty("role", "second");
    recording_->setWordWrap(true);
    recording_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    layout->addWidget(recording_);
    auto* box = new QVBoxLayout(content_);
    box->setContentsMargins(0, 0, 12, 0);
    box->addWidget(makeFields());
    box->addWidget(makeJoints());
    box->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setAccessibleName(windowTitle());
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(content_);
    layout->addWidget(scroll, 1);
    resize(roomFor(*this, {380, 620}));

    connect(who_, &QComboBox::currentIndexChanged, this, [this](int player) {
        if (!filling_ && player >= 0) session_.setActivePlayer(player);
    });
    connect(&session_.document(), &Document::changed, this, &FighterProperties::refresh);
    connect(&session_, &Session::takeChanged, this, &FighterProperties::refresh);
    connect(&session_, &Session::activePlayerChanged, this, &FighterProperties::refresh);
    connect(&session_, &Session::fightersChanged, this, &FighterProperties::refresh);
    refresh();
}

QDoubleSpinBox* FighterProperties::addNumber(const QString& name, const QString& tip) {
    auto* field = new QDoubleSpinBox(content_);
    field->setLocale(fieldLocale());
    field->setKeyboardTracking(false);
    field->setAlignment(Qt::AlignRight);
    field->setFixedWidth(withTextSize(120));
    field->setAccessibleName(name);
    field->setToolTip(tip);
    field->setFocusPolicy(Qt::StrongFocus);
    field->installEventFilter(this);
    connect(field, &QDoubleSpinBox::editingFinished, &session_.document(), &Document::endGesture);
    return field;
}

QWidget* FighterProperties::makeFields() {
    auto* box = new QWidget(content_);
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    form->setSpacing(6);
    form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    form->addRow(headingOf(tr("Time"), box));
    offset_ = addNumber(tr("Start in seconds"),
                        tr("When its first frame stands on the clock of the take; puts the "
                           "fighters in step."));
    offset_->setRange(-3600, 3600);
    offset_->setDecimals(3);
    offset_->setSuffix(tr(" s"));
    form->addRow(tr("Starts at"), offset_);

    form->addRow(headingOf(tr("Place in the bout"), box));
    x_ = addNumber(tr("x in metres"), tr("Shifts the fighter to the side."));
    z_ = addNumber(tr("z in metres"), tr("Shifts the fighter forward or back."));
    turn_ = addNumber(tr("Turn in degrees"),
                      tr("Turns the fighter about the origin of its recording, before it is "
                         "shifted."));
    for (QDoubleSpinBox* metres : {x_, z_}) {
        metres->setRange(-100, 100);
        metres->setDecimals(3);
        metres->setSingleStep(0.05);
        metres->setSuffix(tr(" m"));
    }
    turn_->setRange(-360, 360);
    turn_->setDecimals(1);
    turn_->setSingleStep(5);
    turn_->setSuffix(tr("°"));
    form->addRow(tr("x"), x_);
    form->addRow(tr("z"), z_);
    form->addRow(tr("Turned by"), turn_);

    form->addRow(headingOf(tr("Floor"), box));
    floorFound_ = new QCheckBox(tr("found from the feet"), box);
    floorFound_->setToolTip(
        tr("The height at which the feet rest; switch it off to set the floor "
           "by hand."));
    floor_ = addNumber(tr("Height of the floor in metres"),
                       tr("Where the floor is in the space of the recording."));
    floor_->setRange(-100, 100);
    floor_->setDecimals(3);
    floor_->setSingleStep(0.005);
    floor_->setSuffix(tr(" m"));
    form->addRow(tr("Height"), floor_);
    form->addRow(QString(), floorFound_);

    form->addRow(headingOf(tr("Body model of the project"), box));
    bodyModel_ = new QComboBox(box);
    bodyModel_->setAccessibleName(tr("Body model"));
    bodyModel_->setToolTip(
        tr("How the mass is spread over the body: what the centre of mass and "
           "with it the contact force are made of."));
    bodyModel_->installEventFilter(this);
    form->addRow(bodyModel_);

    connect(offset_, &QDoubleSpinBox::valueChanged, this, [this](double seconds) {
        if (filling_) return;
        session_.document().applyLive(
            QStringLiteral("offset %1 %2").arg(session_.take()).arg(session_.activePlayer()),
            [&](const Project& project) { return setOffset(project, address(), seconds); });
    });
    for (QDoubleSpinBox* field : {x_, z_, turn_})
        connect(field, &QDoubleSpinBox::valueChanged, this, &FighterProperties::applyPlacement);
    connect(floor_, &QDoubleSpinBox::valueChanged, this, &FighterProperties::applyFloor);
    connect(floorFound_, &QCheckBox::toggled, this, [this] {
        if (filling_) return;
        session_.document().endGesture();
        applyFloor();
        session_.document().endGesture();
    });
    connect(bodyModel_, &QComboBox::activated, this, &FighterProperties::applyBodyModel);
    return box;
}

QWidget* FighterProperties::makeJoints() {
    auto* box = new QWidget(content_);
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    form->setSpacing(4);
    form->addRow(headingOf(tr("Which joint is what"), box));
    jointsNote_ = new QLabel(box);
    jointsNote_->setProperty("role", "second");
    jointsNote_->setWordWrap(true);
    form->addRow(jointsNote_);
    for (const Role role : allRoles()) {
        auto* field = new QComboBox(box);
        field->setAccessibleName(tr("Joint of the role %1").arg(roleWords(role)));
        field->setToolTip(
            tr("The joint of the recording that is the %1 of the body.").arg(roleWords(role)));
        field->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        field->setMinimumContentsLength(18);
        field->setFocusPolicy(Qt::StrongFocus);
        field->installEventFilter(this);
        joints_[static_cast<std::size_t>(role)] = field;
        form->addRow(roleWords(role), field);
        connect(field, &QComboBox::activated, this,
                [this, role](int index) { applyRole(role, index); });
    }
    return box;
}

FighterAddress FighterProperties::address() const {
    return {session_.take(), session_.activePlayer()};
}

const Fighter* FighterProperties::fighter() const {
    if (session_.activePlayer() >= session_.playerCount()) return nullptr;
    return &fighterAt(session_.document().project(), address());
}

void FighterProperties::refresh() {
    filling_ = true;
    showFighters();
    const Fighter* shown = fighter();
    content_->setEnabled(shown != nullptr);
    if (shown != nullptr) {
        showRecording(*shown);
        showNumbers(*shown);
        showJoints(*shown);
    } else {
        recording_->setText(
            tr("Start, place, floor and joints of a fighter appear here as soon "
               "as there is a take."));
    }
    showBodyModel();
    filling_ = false;
}

void FighterProperties::showFighters() {
    who_->clear();
    const auto& takes = session_.document().project().takes;
    for (int player = 0; player < session_.playerCount(); ++player) {
        const auto& take = takes[static_cast<std::size_t>(session_.take())];
        const Fighter& each = take.fighters[static_cast<std::size_t>(player)];
        who_->addItem(tr("%1: %2").arg(fighterText(player),
                                       QFileInfo(fromPath(each.recording.path)).fileName()));
    }
    who_->setCurrentIndex(session_.activePlayer());
    who_->setEnabled(who_->count() > 1);
}

void FighterProperties::showRecording(const Fighter& shown) {
    QStringList lines;
    lines.append(fromPath(shown.recording.path));
    if (shown.motion) {
        lines.append(tr("%1 Hz, frames %2 to %3 of %4, %5 joints")
                         .arg(numberText(shown.rate))
                         .arg(framesOf(shown).begin)
                         .arg(framesOf(shown).end - 1)
                         .arg(shown.motion->frameCount)
                         .arg(shown.motion->skeleton->jointCount()));
        lines.append(tr("one unit is %1 m, %2 is up")
                         .arg(numberText(shown.space.metresPerUnit))
                         .arg(shown.space.up == UpAxis::Y ? tr("y") : tr("z")));
    } else {
        lines.append(tr("The recording is missing: File, Find recording."));
    }
    recording_->setText(lines.join(QLatin1Char('\n')));
}

void FighterProperties::showNumbers(const Fighter& shown) {
    offset_->setSingleStep(shown.rate > 0 ? 1 / shown.rate : 0.01);
    offset_->setValue(shown.offset);
    x_->setValue(shown.placement.x);
    z_->setValue(shown.placement.z);
    turn_->setValue(shown.placement.yaw / kDegree);
    floorFound_->setChecked(!shown.floor.has_value());
    floor_->setEnabled(shown.floor.has_value());
    const FighterAnalysis* known = session_.fighter(session_.activePlayer());
    if (shown.floor) {
        floor_->setValue(*shown.floor);
    } else if (known != nullptr && known->body) {
        floor_->setValue(known->body->floor);
    }
}

void FighterProperties::showBodyModel() {
    const BodyModel& now = session_.document().project().bodyModel;
    bodyModel_->clear();
    int current = -1;
    for (const NamedBodyModel& each : broughtBodyModels()) {
        if (each.model == now) current = bodyModel_->count();
        bodyModel_->addItem(each.text);
    }
    if (current < 0) {
        current = bodyModel_->count();
        bodyModel_->addItem(QString::fromStdString(now.name));
    }
    bodyModel_->addItem(tr("From a file…"));
    bodyModel_->setCurrentIndex(current);
    bodyModel_->setEnabled(session_.document().isOpen());
}

void FighterProperties::showJoints(const Fighter& shown) {
    const auto skeleton = shown.motion ? shown.motion->skeleton : nullptr;
    const bool other = skeleton != listed_;
    listed_ = skeleton;
    for (const Role role : allRoles()) {
        QComboBox* field = joints_[static_cast<std::size_t>(role)];
        if (other) {
            field->clear();
            field->addItem(tr("none"));
            if (skeleton) {
                for (const Joint& joint : skeleton->joints)
                    field->addItem(QString::fromStdString(joint.name));
            }
        }
        field->setEnabled(skeleton != nullptr);
        const auto joint = shown.roles[role];
        field->setCurrentIndex(skeleton && joint ? *joint + 1 : 0);
    }
    const auto missing = shown.roles.missing().size();
    jointsNote_->setVisible(missing > 0);
    jointsNote_->setText(missing == 1 ? tr("1 role has no joint.")
                                      : tr("%1 roles have no joint.").arg(missing));
}

void FighterProperties::applyPlacement() {
    const Fighter* shown = fighter();
    if (filling_ || shown == nullptr) return;
    // What a field cannot show exactly must not change with its neighbour.
    Placement placement = shown->placement;
    const QObject* changed = sender();
    if (changed == x_) placement.x = x_->value();
    if (changed == z_) placement.z = z_->value();
    if (changed == turn_) placement.yaw = turn_->value() * kDegree;
    session_.document().applyLive(
        QStringLiteral("place %1 %2").arg(session_.take()).arg(session_.activePlayer()),
        [&](const Project& project) { return setPlacement(project, address(), placement); });
}

void FighterProperties::applyFloor() {
    if (filling_ || fighter() == nullptr) return;
    const auto height =
        floorFound_->isChecked() ? std::nullopt : std::optional<double>(floor_->value());
    session_.document().applyLive(
        QStringLiteral("floor %1 %2").arg(session_.take()).arg(session_.activePlayer()),
        [&](const Project& project) { return setFloor(project, address(), height); });
}

void FighterProperties::applyRole(Role role, int index) {
    if (filling_) return;
    const auto joint = index > 0 ? std::optional<int>(index - 1) : std::nullopt;
    session_.document().apply(
        [&](const Project& project) { return setRole(project, address(), role, joint); });
}

void FighterProperties::applyBodyModel(int index) {
    if (filling_) return;
    const auto& brought = broughtBodyModels();
    BodyModel model = session_.document().project().bodyModel;
    if (index >= 0 && index < static_cast<int>(brought.size())) {
        model = brought[static_cast<std::size_t>(index)].model;
    } else if (index == bodyModel_->count() - 1) {
        const QString path =
            fileToOpen(this, tr("Open a body model"), {}, tr("Body models (*.json)"));
        try {
            if (!path.isEmpty()) model = readBodyModel(toPath(path));
        } catch (const std::exception& error) {
            Q_EMIT session_.document().failed(coreWords(error.what()));
        }
    }
    session_.document().apply([&](const Project& project) { return setBodyModel(project, model); });
    refresh();
}

void FighterProperties::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) refresh();
}

bool FighterProperties::eventFilter(QObject* watched, QEvent* event) {
    // The wheel scrolls the page; it changes a value only where the user has gone to.
    if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
        event->ignore();
        return true;
    }
    return QDialog::eventFilter(watched, event);
}

}  // namespace kumite::studio
