// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>

#include <QtCore/QObject>
#include <QtCore/QSize>
#include <QtCore/QTimer>
#include <QtGui/QIcon>

#include "model/scene/CrowdFrame.h"
#include "render/RenderInput.h"

namespace crowd::widgets {

class EditorState;

/// Small pictures of the view as the entries of a list make it, by their ids: drawn one after the
/// other while nothing else happens. A picture stays until it is let go. Main thread.
class ViewPictures : public QObject
{
    Q_OBJECT

public:
    void forget(); ///< all of them

Q_SIGNALS:
    void drawn();

protected:
    /// `size`: logical pixels. `symbol`: the icon that stands for those that are not drawn yet.
    ViewPictures(EditorState& state, const QSize& size, const char* symbol, QObject* parent);

    [[nodiscard]] QIcon pictureOf(std::uint32_t id);
    /// The picture is drawn anew, and is shown as it is until then.
    void redraw(std::uint32_t id);
    /// Whether anybody sees them now.
    [[nodiscard]] virtual bool isSeen() const { return true; }
    /// The people of an entry's picture; what else it changes is put into the input, which shows
    /// the scene from the view's camera. Null: there is no such entry any more.
    [[nodiscard]] virtual model::CrowdFramePtr frameOf(std::uint32_t id,
                                                       render::RenderInput& input) const = 0;
    [[nodiscard]] EditorState& state() const { return m_state; }

private:
    struct Picture
    {
        QIcon icon; ///< null: not yet
        int tries = 0;
        bool isDue = true; ///< to be drawn
    };
    void drawNext();
    /// Null: see frameOf().
    [[nodiscard]] QIcon draw(std::uint32_t id, bool& isComplete) const;

    EditorState& m_state;
    QSize m_size;
    const char* m_symbol;
    std::map<std::uint32_t, Picture> m_pictures;
    QTimer m_next;
};

} // namespace crowd::widgets
