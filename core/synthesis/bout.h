#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/motion/foot_lock.h"
#include "core/motion/inertialise.h"
#include "core/synthesis/bout_library.h"
#include "core/synthesis/bout_settings.h"
#include "core/synthesis/join_steps.h"
#include "core/synthesis/separation.h"
#include "core/synthesis/time_map.h"

namespace kumite {

/// Two actions brought together in time: the chooser's and the one that the other was showing.
struct Coupling {
    Meeting meeting;  ///< own: the chooser's
    double lag = 0;   ///< seconds, wanted: own moment after the other's
};

/// A choice and everything that led to it.
struct BoutChoice {
    int frame = 0;  ///< boundary frame of the bout, shared by the action that ends and the next
    int player = 0;
    int own = kAnyNode;
    int opponent = kAnyNode;
    Options options;  ///< empty where a captured attack is replayed
    int node = kAnyNode;
    int transition = -1;     ///< of the graph; -1: replayed
    int action = -1;         ///< of B
    double number = 0;       ///< that was drawn, in [0, 1)
    bool forced = false;     ///< a command named it
    bool commanded = false;  ///< it serves the avatar's command
    bool steered = false;    ///< the avatar's model and target were used
    std::optional<Coupling> coupling;
    double distance = 0;     ///< metres from where the sample wanted to begin
    double turn = 0;         ///< radians
    double joinSeconds = 0;  ///< over which the join is made
};

/// What is shown of a fighter now.
struct FighterShown {
    Pose pose;           ///< on the fighter's rig, in the bout's space
    JointFrames joints;  ///< of that pose
    int node = kAnyNode;
    int action = -1;          ///< of B
    int actionBegin = 0;      ///< frame of the bout at which it began
    int actionEnd = 0;        ///< frame at which it will end, as planned now
    double momentFrame = -1;  ///< of the bout, at which its interaction moment is shown; -1: none
    Standing standing{};      ///< feet that are held
};

/// A bout as a stream: a value. A copy is a snapshot, and a snapshot that goes on shows what the
/// original shows. Frame 0 is the start, taken from the recording; every step shows one frame
/// more, at the library's rate, at a cost that does not grow.
class Bout {
public:
    /// Throws Error with one sentence where the library does not hold what the settings ask for.
    Bout(std::shared_ptr<const BoutLibrary> library, const BoutSettings& settings);

    const BoutLibrary& library() const { return *library_; }
    const BoutSettings& settings() const { return settings_; }
    int frame() const { return frame_; }
    double seconds() const { return frame_ / library_->rate; }

    /// From the next choice on; `frame` of the command is not looked at. Throws Error for words
    /// that mean nothing to this library.
    void apply(const BoutCommand& command);
    /// Shows the next frame.
    void step();

    const FighterShown& shown(int player) const { return of(player).shown; }
    /// The last choice of a player; null before the first one.
    std::shared_ptr<const BoutChoice> choice(int player) const { return of(player).choice; }
    /// Those made by the last step, in order.
    std::vector<std::shared_ptr<const BoutChoice>> newChoices() const;

    /// What the avatar was asked for and has not yet shown; empty: nothing.
    const std::string& wish() const { return wish_; }
    const std::optional<Eigen::Vector2d>& target() const { return target_; }

private:
    struct Playing {
        int action = -1;
        int node = kAnyNode;
        TimeMap time;
        int at = 0;  ///< frames shown of it
        int total = 0;
        ActionPlacement placement;
    };
    struct FighterState {
        Playing playing;
        /// Joined poses, before anything is corrected: a frame ago, and the playback buffer: now
        /// and as far ahead as is planned and useful.
        Pose before;
        std::vector<Pose> ahead;
        std::vector<Standing> standing;
        Inertialisation join;
        JoinSteps steps;
        /// Foot points as shown, but for pushes: now and a frame ago.
        std::array<Eigen::Vector3d, 2> feet, feetBefore;
        int sinceJoin = 0;
        std::optional<FootLock> lock;
        FighterShown shown;
        std::shared_ptr<const BoutChoice> choice;
        int choices = 0;
        int replayed = 0;
        int forced = kAnyNode;
        std::vector<double> weights;
    };
    FighterState& of(int player) { return fighters_[static_cast<std::size_t>(player)]; }
    const FighterState& of(int player) const { return fighters_[static_cast<std::size_t>(player)]; }

    void start();
    void startPlaying(int player, int action, const GroundTransform& wanted, double source);
    GroundFrame groundNow(int player) const;
    Eigen::Vector2d comOf(int player) const;
    Station stationOf(const Playing& playing, int player, int at) const;
    ActionSummary summaryOf(int player, const Playing& playing) const;
    Eigen::VectorXd momentNumbers(int player, const Playing& own, const Playing& opponent,
                                  const GroundFrame& ground) const;
    ChoiceRules rulesFor(int player, const Playing& own, const Playing& opponent) const;
    Eigen::Vector2d reachableTarget() const;
    void choose(int player, const std::array<Playing, 2>& before);
    void begin(int player, BoutChoice choice);
    std::optional<Coupling> couple(int player, Playing& own);
    Pose poseOf(int player, const Playing& playing, int at) const;
    Standing standingAt(int player, const Playing& playing, int at) const;
    std::array<FootAtJoin, 2> feetAtJoin(int player, const Playing& next) const;
    void replan(int player);
    void fill(int player);
    void show();

    std::shared_ptr<const BoutLibrary> library_;
    BoutSettings settings_;
    int frame_ = 0;
    std::array<FighterState, 2> fighters_;
    Separation separation_;
    std::string wish_;
    std::vector<int> wishNodes_;
    std::optional<Eigen::Vector2d> target_;
};

}  // namespace kumite
