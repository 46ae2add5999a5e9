#pragma once

#include <QString>

#include <optional>

namespace kumite::studio {

class MainWindow;

/// Waits until the window has read and computed everything, shows the moment `seconds` if given,
/// and writes what the window looks like to a PNG file. False (and a sentence on standard error)
/// where that fails.
bool takePicture(MainWindow& window, const QString& file, std::optional<double> seconds);

/// Lets the window work for a while.
void letWork(int milliseconds);
/// Lets the window work until nothing is being read or computed.
void waitWhileBusy(const MainWindow& window);

}  // namespace kumite::studio
