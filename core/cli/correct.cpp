#include "core/base/text.h"
#include "core/cli/command.h"
#include "core/project/edits.h"
#include "core/project/project_file.h"

namespace kumite::cli {
namespace {

/// `F:G`.
std::pair<int, int> parseMove(const std::string& text) {
    const auto parts = split(text, ':');
    if (parts.size() == 2) {
        const auto from = parseInteger(parts[0]);
        const auto to = parseInteger(parts[1]);
        if (from && to) return {*from, *to};
    }
    throw UsageError("\"" + text + "\" is no move, expected F:G (from frame F to frame G).");
}

/// `F:TEXT`.
std::pair<int, std::string> parseNote(const std::string& text) {
    const std::size_t colon = text.find(':');
    const auto frame = parseInteger(text.substr(0, colon));
    if (colon == std::string::npos || !frame) {
        throw UsageError("\"" + text + "\" is no note, expected F:TEXT (a frame of the action).");
    }
    return {*frame, text.substr(colon + 1)};
}

}  // namespace

void addCorrect(CLI::App& app, Action& action) {
    struct Options {
        std::string project, take;
        int player = 1;
        std::optional<int> remove, restore, add, accept;
        std::string move, note;
        bool forget = false;
    };
    auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "correct", "Corrects one boundary, or notes one action, and saves the project.");
    command->add_option("PROJECT", o->project, "a .kumite file")->required();
    command->add_option("--take", o->take, "name of the take; may be left out if there is one");
    command->add_option("--player", o->player, "1 or 2")->check(CLI::Range(1, 2));
    CLI::Option_group* what = command->add_option_group("correction");
    what->add_option("--remove", o->remove, "remove the boundary at (or within 0.1 s of) a frame");
    what->add_option("--restore", o->restore, "bring back the boundary that was removed there");
    what->add_option("--add", o->add, "add a boundary at a frame");
    what->add_option("--move", o->move, "move a boundary: F:G");
    what->add_option("--accept", o->accept, "say that the boundary at a frame is right");
    what->add_option("--note", o->note,
                     "write about the action at a frame: F:TEXT; without text the note goes");
    what->add_flag("--forget-unmatched", o->forget,
                   "drop the corrections that no longer mean any minimum");
    what->require_option(1);
    command->footer("Example: kumite correct bout.kumite --take round1 --player 1 --remove 245");
    command->callback([o, &action] {
        action = [o](const Streams& streams) {
            std::optional<std::pair<int, int>> move;
            if (!o->move.empty()) move = parseMove(o->move);
            std::optional<std::pair<int, std::string>> note;
            if (!o->note.empty()) note = parseNote(o->note);
            const OpenProject open = openProject(o->project, streams);
            const FighterAddress fighter = fighterNamed(open.project, o->take, o->player);
            MaybeEdit edit;
            if (o->remove) edit = removeBoundary(open.project, open.analysis, fighter, *o->remove);
            if (o->restore) {
                edit = restoreBoundary(open.project, open.analysis, fighter, *o->restore);
            }
            if (o->add) edit = addBoundary(open.project, open.analysis, fighter, *o->add);
            if (move) {
                edit =
                    moveBoundary(open.project, open.analysis, fighter, move->first, move->second);
            }
            if (o->accept) edit = acceptBoundary(open.project, open.analysis, fighter, *o->accept);
            if (note) {
                edit = setNote(open.project, open.analysis, fighter, note->first, note->second);
            }
            if (o->forget) edit = dropUnmatchedCorrections(open.project, open.analysis, fighter);
            if (!edit) {
                streams.out << "Nothing to change.\n";
                return;
            }
            printFindings(saveProject(edit->project, o->project), streams);
            streams.out << edit->name << "\n";
        };
    });
}

}  // namespace kumite::cli
