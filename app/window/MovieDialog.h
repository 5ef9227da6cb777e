// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <QtCore/QStringList>
#include <QtWidgets/QDialog>

#include <glm/vec2.hpp>

#include "app/pictures/PicturePasses.h"

class QCheckBox;
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

    /// At a rate a second: the last one ends by then. At least one.
    [[nodiscard]] int pictures(double framesPerSecond) const;
};

/// What a movie is taken with.
struct MovieCamera
{
    enum class Kind : std::uint8_t {
        Timeline,  ///< as the marks of the timeline move it
        View,      ///< the view's, all the time
        Turntable, ///< once around what the view looks at
        Scene      ///< one of the scene's, all the time
    };
    Kind kind = Kind::View;
    int index = 0; ///< of Scene: of the offered ones
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
        bool hasMoves = false;           ///< the timeline moves a camera
        double lastMark = 0.0;           ///< seconds: after it nothing happens; 0: there is none
    };
    MovieDialog(const Offer& offer, QWidget* parent);

    /// What has been played, as it was; else the scene from its beginning.
    [[nodiscard]] bool isOfRun() const;
    [[nodiscard]] TimeSpan span() const;
    [[nodiscard]] double framesPerSecond() const;
    [[nodiscard]] glm::ivec2 chosenSize() const;
    [[nodiscard]] PicturePasses passes() const; ///< empty: the colours alone
    [[nodiscard]] bool isTransparent() const;   ///< numbered pictures alone can be
    [[nodiscard]] MovieCamera camera() const;

    void accept() override;

private:
    void addSource(QFormLayout& form);
    void addRate(QFormLayout& form);
    void addCameras();
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
    QCheckBox* m_transparent;
};

} // namespace crowd::app
