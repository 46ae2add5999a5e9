#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/cli/command.h"
#include "core/cli/conventions.h"
#include "core/project/edits.h"
#include "core/project/import.h"
#include "core/project/project_file.h"

namespace kumite::cli {
namespace {

constexpr char kHelp[] =
    R"(Usage: kumite new --out P.kumite --take NAME A [B] [options] [--take NAME …]
A and B are the recordings of fighter 1 and 2. Further --take groups add takes.

Of the take:
  --rate HZ            true frame rate, where the headers are wrong
  --trim A:B           frames of the files that the take holds; default: all but a
                       leading rest pose
Of the file before it:
  --offset SECONDS     moment on the take's clock at which its first frame stands
  --place X,Z,YAW      where it stands: metres, and radians (or 90deg)
  --units UNIT         m, dm, cm, mm, inch, foot, cmu or a number of metres; default: found
  --up y|z             axis that points up; default: found
  --floor METRES       height of the floor in the file; default: found
  --root NAME          which skeleton, where a file holds several (NAME, NAME#2 or #2)
  --asf FILE           skeleton of an .amc; default: the only one beside it
  --role ROLE=JOINT    mends the role mapping, e.g. left_knee=LLowLeg; ROLE= for none
Of the project:
  --body FILE          body model (JSON) instead of the male means of de Leva 1996

A file that is there already is kept as a version; see kumite versions.
Example: kumite new --out bout.kumite --take round1 red.bvh blue.bvh --rate 60 --trim 1:)";

/// The words after `new`, read one by one: what an option belongs to depends on what stood
/// before it, which the option parser does not know.
class GroupParser {
public:
    explicit GroupParser(const std::vector<std::string>& words) : words_(words) {}

    std::string out;
    std::string body;
    std::vector<TakeRequest> takes;

    void parse() {
        while (at_ < words_.size()) {
            const std::string word = words_[at_++];
            if (word.starts_with("--")) {
                option(word);
            } else {
                file(word);
            }
        }
        if (out.empty()) throw UsageError("Say where to write the project with --out P.kumite.");
        if (takes.empty()) throw UsageError("Say what it holds with --take NAME A [B].");
        for (const TakeRequest& take : takes) {
            if (take.fighters.empty()) {
                throw UsageError("Take \"" + take.name + "\" names no recording.");
            }
        }
    }

private:
    std::string value(const std::string& option) {
        if (inlineValue_) return *std::exchange(inlineValue_, std::nullopt);
        if (at_ == words_.size() || words_[at_].starts_with("--")) {
            throw UsageError(option + " needs a value.");
        }
        return words_[at_++];
    }

    double number(const std::string& option) {
        const std::string text = value(option);
        const auto parsed = parseNumber(text);
        if (!parsed) throw UsageError(option + " needs a number, not \"" + text + "\".");
        return *parsed;
    }

    TakeRequest& take(const std::string& option) {
        if (takes.empty()) throw UsageError(option + " stands before any --take.");
        return takes.back();
    }

    FighterRequest& fighter(const std::string& option) {
        TakeRequest& current = take(option);
        if (current.fighters.empty()) throw UsageError(option + " stands before any recording.");
        return current.fighters.back();
    }

    void file(const std::string& path) {
        TakeRequest& current = take(path);
        if (current.fighters.size() == 2) {
            throw UsageError("Take \"" + current.name + "\" has two recordings already; " + path +
                             " is one too many.");
        }
        current.fighters.emplace_back().path = path;
    }

    /// `--name value` or `--name=value`.
    void option(const std::string& word) {
        const auto equals = word.find('=');
        const std::string name = word.substr(0, equals);
        if (equals != std::string::npos) inlineValue_ = word.substr(equals + 1);
        set(name);
        if (inlineValue_) throw UsageError(name + " takes no value.");
    }

    void set(const std::string& name) {
        if (name == "--out") {
            out = value(name);
        } else if (name == "--body") {
            body = value(name);
        } else if (name == "--take") {
            takes.emplace_back().name = value(name);
        } else if (name == "--rate") {
            take(name).rate = number(name);
            if (*take(name).rate <= 0) throw UsageError("--rate needs a number above 0.");
        } else if (name == "--trim") {
            take(name).trim = parseRange(value(name));
        } else if (name == "--offset") {
            fighter(name).offset = number(name);
        } else if (name == "--place") {
            fighter(name).placement = placement(value(name));
        } else if (name == "--units") {
            fighter(name).metresPerUnit = parseUnits(value(name));
        } else if (name == "--up") {
            fighter(name).up = parseUp(value(name));
        } else if (name == "--floor") {
            fighter(name).floor = number(name);
        } else if (name == "--root") {
            fighter(name).root = value(name);
        } else if (name == "--asf") {
            fighter(name).asf = value(name);
        } else if (name == "--role") {
            fighter(name).roles.push_back(role(value(name)));
        } else {
            throw UsageError(name + " is no option of new; see kumite new --help.");
        }
    }

    static Placement placement(const std::string& text) {
        auto parts = split(text, ',');
        double unit = 1.0;
        if (parts.size() == 3 && parts[2].ends_with("deg")) {
            parts[2].remove_suffix(3);
            unit = std::numbers::pi / 180.0;
        }
        const auto x = parseNumber(parts[0]);
        const auto z = parts.size() == 3 ? parseNumber(parts[1]) : std::nullopt;
        const auto yaw = parts.size() == 3 ? parseNumber(parts[2]) : std::nullopt;
        if (!x || !z || !yaw) throw UsageError("\"" + text + "\" is no place, expected X,Z,YAW.");
        return {*x, *z, *yaw * unit};
    }

    static std::pair<Role, std::string> role(const std::string& text) {
        const auto equals = text.find('=');
        const auto found = roleFromName(text.substr(0, equals));
        if (equals == std::string::npos || !found) {
            std::string known;
            for (const Role r : allRoles())
                known += " " + std::string(roleName(r));
            throw UsageError("\"" + text + "\" is no role, expected ROLE=JOINT with one of" +
                             known + ".");
        }
        return {*found, text.substr(equals + 1)};
    }

    const std::vector<std::string>& words_;
    std::size_t at_ = 0;
    std::optional<std::string> inlineValue_;
};

}  // namespace

void addNew(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("new", "Makes a project of recordings.");
    command->prefix_command();
    command->set_help_flag();  // the order of words matters: help is ours, too
    command->callback([command, &action] {
        action = [words = command->remaining()](const Streams& streams) {
            for (const std::string& word : words) {
                if (word != "--help" && word != "-h") continue;
                streams.out << kHelp << "\n";
                return;
            }
            GroupParser parser(words);
            parser.parse();
            Edit edit;
            if (!parser.body.empty()) edit.project.bodyModel = readBodyModel(parser.body);
            for (const TakeRequest& request : parser.takes) {
                const ImportedTake imported =
                    importTake(request, streams.progress("reading " + request.name));
                printFindings(imported.findings, streams);
                edit = *addTake(edit.project, imported.take);
            }
            refuseToOverwrite(parser.out, recordingFiles(edit.project));
            if (std::filesystem::exists(parser.out)) {
                printFindings({note(parser.out + " was there already; it is kept as a version (see "
                                                 "kumite versions).")},
                              streams);
            }
            printFindings(saveProject(edit.project, parser.out), streams);
            streams.out << parser.out << "\n";
        };
    });
}

}  // namespace kumite::cli
