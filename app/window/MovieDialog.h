// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QtCore/QStringList>
#include <QtWidgets/QDialog>

#include <glm/vec2.hpp>

#include "app/pictures/PicturePasses.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;

namespace crowd::app {

class PassFields;
class PictureSizeFields;

/// Seconds of the transport.
struct TimeSpan
{
    double from = 0.0;
    double to = 0.0;
};

/// What File > Make Movie asks before it asks for a name: of what, from when to when, how many
/// pictures a second, their size, the camera, and what else files hold. Proposes what was chosen
/// last, and the whole run where there is one; of either no more than the scene's play range.
class MovieDialog : public QDialog
{
    Q_OBJECT

public:
    struct Offer
    {
        glm::ivec2 view{1280, 720};      ///< size of the picture in the window, physical pixels
        QStringList cameras;             ///< of the scene
        std::optional<TimeSpan> run{};   ///< what has been played; none: nothing
        std::optional<TimeSpan> range{}; ///< what of all time is played; none: all
    };
    MovieDialog(const Offer& offer, QWidget* parent);

    /// What has been played, as it was; else the scene from its beginning.
    [[nodiscard]] bool isOfRun() const;
    [[nodiscard]] TimeSpan span() const;
    [[nodiscard]] double framesPerSecond() const;
    [[nodiscard]] glm::ivec2 chosenSize() const;
    [[nodiscard]] PicturePasses passes() const; ///< empty: the colours alone
    [[nodiscard]] int camera() const;           ///< index of the offered ones; -1: the view

    void accept() override;

private:
    void addSource(QFormLayout& form);
    void addRate(QFormLayout& form);
    void chooseSource();
    void countPictures();

    Offer m_offer;
    QComboBox* m_sources;
    QDoubleSpinBox* m_from;
    QDoubleSpinBox* m_to;
    QComboBox* m_rates;
    QLabel* m_count;
    PictureSizeFields* m_size;
    QComboBox* m_cameras;
    PassFields* m_passes;
};

} // namespace crowd::app
