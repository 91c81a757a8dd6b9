#include "ui/nets/net_styles.h"

#include <algorithm>
#include <array>

namespace ui {

namespace {

/// Okabe and Ito's hues without black, which no board shows.
constexpr std::array<QRgb, 7> kHues = {0xffe69f00, 0xff56b4e9, 0xff009e73, 0xfff0e442,
                                       0xff0072b2, 0xffd55e00, 0xffcc79a7};

std::vector<model::BoardNet> sorted(std::span<const model::BoardNet> nets) {
    std::vector<model::BoardNet> all(nets.begin(), nets.end());
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

/// The state with `edit` done to the styles of these nets.
template <class Edit>
NetStyles::State edited(const NetStyles& styles, std::span<const model::BoardNet> nets, const Edit& edit) {
    NetStyles::State changed;
    for (const model::BoardNet& net : sorted(nets)) {
        edit(changed.emplace_back(styles.of(net)));
    }
    NetStyles::State after;
    // Of two styles of one net the changed one is taken.
    std::ranges::set_union(changed, styles.state(), std::back_inserter(after), {}, &NetStyle::net, &NetStyle::net);
    std::erase_if(after, [](const NetStyle& style) { return !style.colour && !style.isHidden; });
    return after;
}

QString counted(std::size_t nets) {
    return nets == 1 ? NetStyles::tr("one net") : NetStyles::tr("%L1 nets").arg(nets);
}

}  // namespace

QRgb highlightColour(std::size_t place) {
    const glm::vec3 colour = render::kHighlightColours[place % render::kHighlightColours.size()];
    return QColor::fromRgbF(colour.r, colour.g, colour.b).rgb();
}

std::size_t nearestColour(std::span<const QRgb> palette, QRgb colour) {
    const auto distance = [&](QRgb other) {
        const int red = qRed(other) - qRed(colour);
        const int green = qGreen(other) - qGreen(colour);
        const int blue = qBlue(other) - qBlue(colour);
        return red * red + green * green + blue * blue;
    };
    return static_cast<std::size_t>(std::ranges::min_element(palette, {}, distance) - palette.begin());
}

void NetStyles::setState(State state) {
    m_state = std::move(state);
    emit changed();
}

NetStyle NetStyles::of(const model::BoardNet& net) const {
    const auto found = std::ranges::lower_bound(m_state, net, {}, &NetStyle::net);
    return found != m_state.end() && found->net == net ? *found : NetStyle{net, std::nullopt, false};
}

bool NetStyles::hasColours() const {
    return std::ranges::any_of(m_state, [](const NetStyle& style) { return style.colour.has_value(); });
}

void NetStyles::colour(std::span<const model::BoardNet> nets, std::optional<QRgb> colour) {
    emit asked(tr("colour of %1").arg(counted(nets.size())),
               edited(*this, nets, [&](NetStyle& style) { style.colour = colour; }));
}

void NetStyles::colourAnew(std::span<const model::BoardNet> nets) {
    std::array<std::size_t, kHues.size()> uses{};
    for (const NetStyle& style : m_state) {
        const auto hue = std::ranges::find(kHues, style.colour.value_or(0));
        if (hue != kHues.end()) {
            ++uses[static_cast<std::size_t>(hue - kHues.begin())];
        }
    }
    emit asked(tr("colour of %1").arg(counted(nets.size())), edited(*this, nets, [&](NetStyle& style) {
                   if (!style.colour) {
                       const auto least = static_cast<std::size_t>(std::ranges::min_element(uses) - uses.begin());
                       ++uses[least];
                       style.colour = kHues[least];
                   }
               }));
}

void NetStyles::hide(std::span<const model::BoardNet> nets, bool isHidden) {
    emit asked((isHidden ? tr("hiding %1") : tr("showing %1")).arg(counted(nets.size())),
               edited(*this, nets, [&](NetStyle& style) { style.isHidden = isHidden; }));
}

void NetStyles::isolate(std::span<const model::BoardNet> nets, const model::StepTree& tree) {
    const std::vector<model::BoardNet> kept = sorted(nets);
    State after;
    for (std::uint32_t step = 0; step < tree.steps.size(); ++step) {
        for (std::size_t row = 0; row < tree.steps[step]->nets.size(); ++row) {
            NetStyle style = of({step, model::NetId{row}});
            style.isHidden = !std::ranges::binary_search(kept, style.net);
            if (style.colour || style.isHidden) {
                after.push_back(style);
            }
        }
    }
    if (after == m_state) {
        showAll();
    } else {
        emit asked(tr("isolating %1").arg(counted(kept.size())), after);
    }
}

void NetStyles::showAll() {
    State after = m_state;
    std::ranges::for_each(after, [](NetStyle& style) { style.isHidden = false; });
    std::erase_if(after, [](const NetStyle& style) { return !style.colour; });
    emit asked(tr("showing all nets"), after);
}

void NetStyles::clearColours() {
    State after = m_state;
    std::ranges::for_each(after, [](NetStyle& style) { style.colour.reset(); });
    std::erase_if(after, [](const NetStyle& style) { return !style.isHidden; });
    emit asked(tr("colours of nets"), after);
}

void NetStyles::setDim(float dim) {
    m_dim = dim;
    emit dimChanged();
}

std::vector<QRgb> NetStyles::palette() const {
    std::vector<QRgb> colours;
    for (const NetStyle& style : m_state) {
        if (style.colour) {
            colours.push_back(*style.colour);
        }
    }
    std::ranges::sort(colours);
    colours.erase(std::unique(colours.begin(), colours.end()), colours.end());
    colours.resize(std::min(colours.size(), kMostColours));
    return colours;
}

}  // namespace ui
