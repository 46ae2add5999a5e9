#pragma once

#include <stdexcept>
#include <string>

namespace kumite {

/// What a user is told when the work cannot be done: one sentence that says what is wrong and
/// what to do. Caught in three places only: a studio action, the job runner, the command's main.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The user cancelled. Not a failure: whoever catches it says nothing.
class Cancelled : public Error {
public:
    Cancelled() : Error("Cancelled.") {}
};

/// Something in a file is wrong. `what()` reads `file:line:column: sentence`.
class InputError : public Error {
public:
    /// `line` and `column` count from 1; 0 means that the place is not known and is not printed.
    InputError(const std::string& file, int line, int column, const std::string& sentence)
        : Error(place(file, line, column) + sentence), line_(line), column_(column) {}

    int line() const { return line_; }
    int column() const { return column_; }

private:
    static std::string place(const std::string& file, int line, int column) {
        std::string text = file + ":";
        if (line > 0) text += std::to_string(line) + ":";
        if (line > 0 && column > 0) text += std::to_string(column) + ":";
        return text + " ";
    }

    int line_;
    int column_;
};

}  // namespace kumite
