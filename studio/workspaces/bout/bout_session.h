#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/project/bout.h"
#include "core/project/interaction.h"
#include "core/synthesis/bout_quality.h"
#include "core/synthesis/bout_tape.h"
#include "studio/app/session.h"

namespace kumite::studio {

/// What bouts are made from, and the document that it was learnt from.
struct BoutSource {
    Project project;                             ///< of the document then
    Interaction interaction;                     ///< of the whole document
    std::shared_ptr<const BoutLibrary> library;  ///< for the settings; null where there is none
    std::array<Fighter, 2> like;                 ///< whose skeletons both have
    BoutSettings settings;                       ///< with the attack that is replayed
    QString whyNothing;                          ///< what to do where there is no library
};

/// A bout's quality beside the recording's.
struct BoutJudgement {
    Quality bout;
    Quality recording;
    double seconds = 0;  ///< of the bout that was judged
};

/// The bout that the Bout workspace fights: learns in the background what bouts are made from,
/// plays, goes back, takes other choices and commands. Its views listen to it. All thinking is
/// `core/synthesis`; this keeps time and tells. Belongs to the GUI thread.
class BoutSession : public QObject {
    Q_OBJECT

public:
    explicit BoutSession(Session& session, QObject* parent = nullptr);

    Session& session() { return session_; }
    JobRunner& jobs() { return jobs_; }
    JobRunner& judging() { return judging_; }
    JobRunner& writing() { return writing_; }
    /// Learns only while somebody looks; a bout that plays is paused when nobody does.
    void setActive(bool active);
    bool isActive() const { return active_; }
    bool isPreparing() const { return jobs_.isRunning() || due_.isActive(); }

    /// Null while there is no bout.
    const BoutTape* tape() const { return tape_ ? &*tape_ : nullptr; }
    const BoutLibrary& library() const { return tape_->now().library(); }
    /// Why there is no bout; empty where there is one or one is being prepared.
    QString whyNothing() const;
    /// Labels or boundaries changed since the bout was begun: a new one would know them.
    bool isOutdated() const { return outdated_; }

    /// A fighter with the skeleton of a player; only while there is a bout.
    const Fighter& like(int player) const { return source_->like[std::size_t(player)]; }

    /// How the next bout is begun; a change of anything but the seed's draws begins anew.
    const BoutSettings& wanted() const { return wanted_; }
    void setWanted(const BoutSettings& settings);
    /// From the beginning, with what the document holds now.
    void begin();

    bool isPlaying() const { return timer_.isActive(); }
    void setPlaying(bool playing);
    double speed() const { return speed_; }
    void setSpeed(double speed);
    /// Puts the head on a frame that was shown; later ones wait there.
    void seek(int frame);
    void step(int frames);
    /// The project differs from the one that the bout was learnt from only by what was kept of it:
    /// the bout goes on.
    void stayWith(const Project& project);
    double rate() const;

    /// What is explained: the choice that was pointed to, else the last one of the active fighter
    /// before the head. Null: none yet.
    std::shared_ptr<const BoutChoice> choice() const;
    void pointTo(std::shared_ptr<const BoutChoice> choice);
    /// Makes a choice again with another label and goes on from there.
    void chooseInstead(const BoutChoice& choice, int node);
    /// From the head on draws are those of another seed.
    void reseed(std::uint64_t seed);

    /// What keys may ask an avatar for, in the order of keys: groups of strikes, then aspects.
    const std::vector<std::string>& commandWords() const { return words_; }
    bool steers() const { return tape_ && tape_->now().settings().mode == BoutMode::Avatar; }
    void ask(const std::string& words);
    void release();
    /// Where the avatar shall be; nothing: anywhere.
    void setTarget(const std::optional<Eigen::Vector2d>& target);

    /// Measured in the background when asked for; nothing until then.
    const std::optional<BoutJudgement>& judgement() const { return judgement_; }
    void judge();

    /// A node's label as people read it.
    QString nameOf(int player, int node) const;
    /// Who the active fighter is.
    int player() const { return std::clamp(session_.activePlayer(), 0, 1); }

Q_SIGNALS:
    /// Another bout, or none.
    void begun();
    /// Another frame is shown.
    void moved();
    /// Playing, speed, wish, target or what is wanted.
    void stateChanged();
    /// Another choice is explained, or others were made.
    void choicesChanged();
    void judged();
    void failed(const QString& sentence);

private:
    bool isOf(const Project& project) const;
    void prepare();
    void take(BoutSource source);
    void advance();
    /// False where core says in a sentence that it cannot be done.
    bool attempt(const std::function<void()>& act);
    /// Does what cuts the bout at the head: what was measured or pointed to is of another one then.
    bool change(const std::function<void()>& act);
    void gatherWords();
    void shown();

    Session& session_;
    JobRunner jobs_;
    JobRunner judging_;
    JobRunner writing_;
    QTimer due_;
    QTimer timer_;
    QElapsedTimer clock_;
    double owed_ = 0;  ///< frames that time asks for and that are not yet shown
    double speed_ = 1;
    std::shared_ptr<const BoutSource> source_;
    BoutSettings wanted_;
    bool anew_ = false;  ///< another bout was asked for and is not yet being prepared
    std::vector<std::string> words_;
    std::optional<BoutTape> tape_;
    std::shared_ptr<const BoutChoice> pointed_;
    std::shared_ptr<const BoutChoice> told_;  ///< the choice that views know
    std::size_t choices_ = 0;                 ///< how many they know
    std::optional<BoutJudgement> judgement_;
    std::shared_ptr<const RecordingQuality> recording_;  ///< of the library
    bool active_ = false;
    bool outdated_ = true;
};

}  // namespace kumite::studio
