// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <memory>

namespace espalier {

class MainWindow;
class Settings;
class Tour;

/// What a person asks for who wants to know: the help, a recipe of it that plays, and the tour.
class HelpController : public QObject {
    Q_OBJECT

public:
    /// Both outlive it; the window is complete. @p isSample is what the one before it says.
    HelpController(MainWindow& window, Settings& settings, bool isSample = false);
    ~HelpController() override;

    Tour& tour() { return *m_tour; }
    /// Whether what the recipe runner plays is a sample.
    bool isSample() const { return m_isSample; }

    /// Opens the help at the page of what is at hand; closes it if that is what it shows.
    void toggle();
    /// Puts away the tour, or else the help; whether there was one.
    bool putAway();
    void startTour();
    /// Shows a newcomer around: the first time that it is called on a person's machine, and never again.
    void startFirstTour();
    /// Plays a recipe that belongs to the program. Asks about unsaved changes first; its own tree is none, as
    /// long as nobody works on it.
    void playSample(const QString& fileName);

private:
    void close();
    void handOverSample();
    /// Of the sheet that has the keys, or else of the tool in hand.
    QString pageAtHand() const;

    MainWindow& m_window;
    Settings& m_settings;
    std::unique_ptr<Tour> m_tour;
    bool m_isSample;
};

} // namespace espalier
