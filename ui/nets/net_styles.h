#pragma once

#include <QColor>
#include <QObject>
#include <optional>
#include <span>
#include <vector>

#include "model/board/copies.h"
#include "render/scene/element_state.h"

namespace ui {

/// How one net is drawn otherwise than its layers.
struct NetStyle {
    model::BoardNet net;
    std::optional<QRgb> colour;
    bool isHidden = false;
    bool operator==(const NetStyle&) const = default;
};

/// The colours and the hiding of nets. Only nets with a style of their own have an entry, so that boards of a million
/// nets cost nothing. Commands request a change (`asked`); whoever holds the history of edits makes it with `setState`.
class NetStyles : public QObject {
    Q_OBJECT

public:
    using State = std::vector<NetStyle>;  ///< by net, rising; none that says nothing

    using QObject::QObject;

    void setState(State state);
    [[nodiscard]] const State& state() const { return m_state; }
    [[nodiscard]] NetStyle of(const model::BoardNet& net) const;
    [[nodiscard]] bool isHidden(const model::BoardNet& net) const { return of(net).isHidden; }
    [[nodiscard]] bool hasColours() const;

    /// None takes the colour away.
    void colour(std::span<const model::BoardNet> nets, std::optional<QRgb> colour);
    /// Gives each net without a colour the hue that is used least, of eight that everybody can distinguish.
    void colourAnew(std::span<const model::BoardNet> nets);
    void hide(std::span<const model::BoardNet> nets, bool isHidden);
    /// Hides all nets of the tree but these; where that is so already, shows all again.
    void isolate(std::span<const model::BoardNet> nets, const model::StepTree& tree);
    void showAll();
    void clearColours();
    /// By how much what does not stand out is darkened, 0 to 1.
    void setDim(float dim);
    [[nodiscard]] float dim() const { return m_dim; }

    /// The different colours, rising; at most `kMostColours`: nets beyond those take the one most alike.
    static constexpr std::size_t kMostColours = shader::kHighlightRow;
    [[nodiscard]] std::vector<QRgb> palette() const;

signals:
    /// The user wants this; `what` names the edit.
    void asked(const QString& what, const ui::NetStyles::State& after);
    void changed();
    void dimChanged();

private:
    State m_state;
    float m_dim = render::kDimRest;
};

/// What a net is drawn in as the `place`-th of those that are highlighted, if it has no colour of its own.
[[nodiscard]] QRgb highlightColour(std::size_t place);

/// The row of a palette that is most like a colour; it has one.
[[nodiscard]] std::size_t nearestColour(std::span<const QRgb> palette, QRgb colour);

}  // namespace ui
