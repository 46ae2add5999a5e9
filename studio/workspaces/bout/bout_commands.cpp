#include "studio/workspaces/bout/bout_commands.h"

#include <QApplication>
#include <QCoreApplication>
#include <QFileInfo>
#include <QProgressDialog>

#include <cmath>

#include "core/project/kept_bout.h"
#include "studio/app/commands.h"
#include "studio/app/core_words.h"
#include "studio/app/folders.h"
#include "studio/app/questions.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/bout/bout_export.h"
#include "studio/workspaces/bout/bout_session.h"

namespace kumite::studio {

namespace {

/// Translations of this file.
struct BoutCommands {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::BoutCommands)
};

/// "Kick", "Right punch": what a key asks for.
QString commandText(const BoutSession& bout, const std::string& words) {
    const Vocabulary& vocabulary = bout.library().vocabulary();
    const auto aspect = vocabulary.find(words);
    QString name =
        aspect ? vocabularyWords(vocabulary[*aspect].name) : QString::fromStdString(words);
    if (!name.isEmpty()) name[0] = name[0].toUpper();
    return BoutCommands::tr("Avatar: %1").arg(name);
}

/// A name in the folder of the document for what comes of a bout.
QString suggestion(BoutSession& bout, const QString& suffix) {
    const auto seed = bout.tape()->now().settings().seed;
    return startFolder(bout.session().document()) + QLatin1Char('/') +
           QStringLiteral("bout-%1%2").arg(seed).arg(suffix);
}

void keepAsTake(BoutSession& bout, StageView& stage) {
    Document& document = bout.session().document();
    if (!document.isCurrent()) {
        Q_EMIT bout.session().hinted(BoutCommands::tr("The analysis is not finished yet."));
        return;
    }
    bout.setPlaying(false);
    // While the dialog is open another bout may be begun.
    const BoutTape tape = *bout.tape();
    const QString path = fileToSave(stage.window(), BoutCommands::tr("Keep the bout as a take"),
                                    suggestion(bout, QStringLiteral(".bvh")),
                                    BoutCommands::tr("Recordings, NAME-1 and NAME-2 (*.bvh)"));
    if (path.isEmpty()) return;
    const QFileInfo info(path);
    bout.writing().start(
        BoutCommands::tr("Keeping the bout"),
        [project = document.project(), analysis = document.analysis(), tape,
         name = info.completeBaseName().toStdString(),
         folder = info.path().toStdString()](const Progress& progress) {
            return keepBout(project, analysis, tape, name, folder, progress);
        },
        [&bout, before = document.project()](KeptBout kept) {
            Document& now = bout.session().document();
            if (!(now.project() == before)) {
                Q_EMIT bout.failed(
                    BoutCommands::tr("The project changed while the bout was written. Its files "
                                     "are there; open them as a take, or keep it again under "
                                     "another name."));
                return;
            }
            const std::string take = kept.edit.project.takes.back().name;
            now.apply(Document::ProjectEdit(
                [&kept](const Project&) { return MaybeEdit(std::move(kept.edit)); }));
            bout.stayWith(now.project());
            Q_EMIT bout.session().hinted(
                BoutCommands::tr(
                    "Kept as take %1. Detection alone finds %2 % and %3 % of its boundaries.")
                    .arg(QString::fromStdString(take))
                    .arg(std::lround(100 * kept.foundAgain[0]))
                    .arg(std::lround(100 * kept.foundAgain[1])));
        });
}

/// Pictures of every shown frame at 30 Hz: the window shows them one by one while they are written.
/// Nothing where it was cancelled; a sentence where it failed.
std::optional<QString> writeFilm(BoutSession& bout, StageView& stage, const QString& path) {
    bout.jobs().cancel();  // no other bout meanwhile
    QProgressDialog progress(BoutCommands::tr("Writing the bout"), BoutCommands::tr("Cancel"), 0,
                             1000, stage.window());
    progress.setWindowModality(Qt::WindowModal);
    const int head = bout.tape()->frame();
    FilmFrames frames;
    const double seconds = bout.tape()->end() / bout.rate();
    frames.count = static_cast<int>(std::floor(seconds * frames.rate)) + 1;
    frames.picture = [&](int index) {
        bout.seek(static_cast<int>(std::lround(index / frames.rate * bout.rate())));
        return stage.picture();
    };
    frames.goesOn = [&](double share) {
        progress.setValue(static_cast<int>(1000 * share));
        return !progress.wasCanceled();
    };
    const bool video = path.endsWith(QLatin1String(".mp4"), Qt::CaseInsensitive);
    const QString failure = video ? writeVideo(frames, path) : writePictures(frames, path);
    bout.seek(head);
    if (progress.wasCanceled()) return std::nullopt;
    return failure;
}

void exportBout(BoutSession& bout, StageView& stage) {
    bout.setPlaying(false);
    const BoutTape tape = *bout.tape();
    const QString path = fileToSave(
        stage.window(), BoutCommands::tr("Export the bout"),
        suggestion(bout, QStringLiteral(".bvh")),
        BoutCommands::tr(
            "Motion of both, NAME-1 and NAME-2 (*.bvh);;glTF: skeletons and animation (*.glb);;"
            "Pictures, 30 a second (*.png);;Video, by ffmpeg (*.mp4);;Log: everything that makes "
            "it again (*.json)"));
    if (path.isEmpty()) return;
    rememberFolder(path);
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == QLatin1String("png") || suffix == QLatin1String("mp4")) {
        if (!bout.tape()) return;
        const std::optional<QString> failure = writeFilm(bout, stage, path);
        if (!failure) {
            Q_EMIT bout.session().hinted(BoutCommands::tr("Cancelled."));
        } else if (failure->isEmpty()) {
            Q_EMIT bout.session().hinted(BoutCommands::tr("Written: %1").arg(path));
        } else {
            Q_EMIT bout.failed(*failure);
        }
        return;
    }
    bout.writing().start(
        BoutCommands::tr("Writing the bout"),
        [project = bout.session().document().project(), tape, path](const Progress& progress) {
            writeBout(project, tape, path, progress);
            return path;
        },
        [&bout](const QString& written) {
            Q_EMIT bout.session().hinted(BoutCommands::tr("Written: %1").arg(written));
        });
}

}  // namespace

void addBoutCommands(CommandTable& commands, BoutSession& bout, StageView& stage) {
    const QString menu = BoutCommands::tr("&Bout");
    const QString group = QLatin1Char('-') + menu;
    BoutSession* session = &bout;
    StageView* view = &stage;
    const auto there = [session] { return session->tape() != nullptr; };
    // What is being written is not given up for another file.
    const auto writable = [session] {
        return session->tape() != nullptr && !session->writing().isRunning();
    };
    commands.add({"bout.play",
                  menu,
                  BoutCommands::tr("&Fight or pause"),
                  {QKeySequence("Space")},
                  [session] { session->setPlaying(!session->isPlaying()); },
                  there,
                  {},
                  "play"});
    commands.add({"bout.begin",
                  menu,
                  BoutCommands::tr("Begin a&new"),
                  {QKeySequence("Ctrl+B")},
                  [session] { session->begin(); },
                  there});
    commands.add({"bout.nextSeed",
                  menu,
                  BoutCommands::tr("Begin with the next &seed"),
                  {QKeySequence("Ctrl+Shift+B")},
                  [session] {
                      BoutSettings settings = session->wanted();
                      ++settings.seed;
                      session->setWanted(settings);
                  },
                  there});
    commands.add({"bout.reseed",
                  menu,
                  BoutCommands::tr("Go on from here with other &draws"),
                  {QKeySequence("R")},
                  [session] {
                      const auto& tape = *session->tape();
                      session->reseed(tape.now().settings().seed + 1 +
                                      static_cast<std::uint64_t>(tape.commands().size()));
                  },
                  there});
    const auto step = [&](const char* id, const QString& title, const QList<QKeySequence>& keys,
                          double seconds, const QString& icon, const QString& where) {
        commands.add({id,
                      where,
                      title,
                      keys,
                      [session, seconds] {
                          const int frames =
                              static_cast<int>(std::lround(seconds * session->rate()));
                          session->step(frames != 0 ? frames : seconds < 0 ? -1 : 1);
                      },
                      there,
                      {},
                      icon});
    };
    step("bout.back", BoutCommands::tr("One frame back"), {QKeySequence("Left"), QKeySequence(",")},
         -1e-6, "step_back", group);
    step("bout.on", BoutCommands::tr("One frame on"), {QKeySequence("Right"), QKeySequence(".")},
         1e-6, "step_on", menu);
    step("bout.backSecond", BoutCommands::tr("One second back"), {QKeySequence("Shift+Left")}, -1,
         {}, menu);
    step("bout.onSecond", BoutCommands::tr("One second on"), {QKeySequence("Shift+Right")}, 1, {},
         menu);
    commands.add({"bout.start",
                  menu,
                  BoutCommands::tr("To the start"),
                  {QKeySequence("Home")},
                  [session] { session->seek(0); },
                  there,
                  {},
                  "to_begin"});
    commands.add({"bout.end",
                  menu,
                  BoutCommands::tr("To the end of what was shown"),
                  {QKeySequence("End")},
                  [session] { session->seek(session->tape()->end()); },
                  there,
                  {},
                  "to_end"});
    commands.add({"bout.slower",
                  menu,
                  BoutCommands::tr("Slower"),
                  {QKeySequence("-")},
                  [session] { session->setSpeed(session->speed() / 2); },
                  there});
    commands.add({"bout.faster",
                  menu,
                  BoutCommands::tr("Faster"),
                  {QKeySequence("+"), QKeySequence("=")},
                  [session] { session->setSpeed(session->speed() * 2); },
                  there});
    const auto mode = [&](const char* id, const QString& title, BoutMode which,
                          const QString& where) {
        commands.add({id,
                      where,
                      title,
                      {},
                      [session, which] {
                          BoutSettings settings = session->wanted();
                          settings.mode = which;
                          session->setWanted(settings);
                      },
                      there,
                      [session, which] { return session->wanted().mode == which; }});
    };
    mode("bout.automatic", BoutCommands::tr("&Automatic: the model decides"), BoutMode::Automatic,
         group);
    mode("bout.avatar", BoutCommands::tr("A&vatar: keys lead one fighter"), BoutMode::Avatar, menu);
    mode("bout.passive", BoutCommands::tr("&Passive: one answers a captured attack"),
         BoutMode::Passive, menu);
    for (int key = 1; key <= kAvatarKeys; ++key) {
        const auto index = static_cast<std::size_t>(key - 1);
        Command command{QStringLiteral("bout.act%1").arg(key),
                        key == 1 ? group : menu,
                        BoutCommands::tr("Avatar: key %1").arg(key),
                        {QKeySequence(QString::number(key))},
                        [session, index] {
                            const auto& words = session->commandWords();
                            if (index < words.size()) session->ask(words[index]);
                        }};
        command.enabled = [session, index] {
            return session->steers() && index < session->commandWords().size();
        };
        command.repeats = false;
        commands.add(std::move(command));
    }
    commands.add({"bout.release",
                  menu,
                  BoutCommands::tr("Avatar: forget &what was asked for"),
                  {QKeySequence("0")},
                  [session] {
                      session->release();
                      session->setTarget(std::nullopt);
                  },
                  [session] { return session->steers(); }});
    commands.add({"bout.measure",
                  group,
                  BoutCommands::tr("&Measure the quality"),
                  {QKeySequence("Q")},
                  [session] { session->judge(); },
                  there});
    commands.add({"bout.keep",
                  menu,
                  BoutCommands::tr("&Keep as a take…"),
                  {QKeySequence("Ctrl+T")},
                  [session, view] { keepAsTake(*session, *view); },
                  writable});
    commands.add({"bout.export",
                  menu,
                  BoutCommands::tr("E&xport the bout…"),
                  {QKeySequence("Ctrl+Shift+E")},
                  [session, view] { exportBout(*session, *view); },
                  writable});
    CommandTable* table = &commands;
    QObject::connect(session, &BoutSession::begun, table, [table, session] {
        const auto words = session->commandWords();
        for (int key = 1; key <= kAvatarKeys; ++key) {
            const auto index = static_cast<std::size_t>(key - 1);
            table->setText(QStringLiteral("bout.act%1").arg(key),
                           index < words.size() ? commandText(*session, words[index])
                                                : BoutCommands::tr("Avatar: key %1").arg(key));
        }
        table->refresh();
    });
    QObject::connect(session, &BoutSession::stateChanged, table, &CommandTable::refresh);
}

}  // namespace kumite::studio
