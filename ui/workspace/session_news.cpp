#include "ui/workspace/session_news.h"

#include <QStringList>
#include <algorithm>
#include <string_view>
#include <utility>

#include "model/session/session_news.h"
#include "ui/workspace/workspace.h"

namespace ui {

namespace {

/// A part of the file by the word that panels and the guide have for it.
QString nameOf(const std::string& part) {
    const std::pair<std::string_view, QString> kNames[] = {
        {"thickness_nm", SessionNews::tr("thicknesses")},  {"views", SessionNews::tr("saved views")},
        {"nets", SessionNews::tr("colours of nets")},      {"desk", SessionNews::tr("cameras and layers")},
        {"measurements", SessionNews::tr("measurements")}, {"sections", SessionNews::tr("sections")},
        {"layer_sets", SessionNews::tr("layer sets")},     {"board_colours", SessionNews::tr("colours of the board")},
        {"design_rules", SessionNews::tr("rules")},        {"waivers", SessionNews::tr("waivers")},
    };
    const auto* const found =
        std::ranges::find(kNames, std::string_view(part), [](const auto& row) { return row.first; });
    return found != std::end(kNames) ? found->second : QString::fromStdString(part);
}

/// What others did to the part itself.
QString textOfPart(const model::session::KnownPart& part, const QString& name) {
    if (part.keepsOthers && part.replacesOthers) {
        return SessionNews::tr(
                   "%1 in the session file were changed outside this window, too. What was changed here as well was "
                   "replaced; the rest is kept, and Reload (F5) shows it.")
            .arg(name);
    }
    if (part.replacesOthers) {
        return SessionNews::tr(
                   "%1 in the session file were changed outside this window, too. What was changed here as well was "
                   "replaced.")
            .arg(name);
    }
    return part.keepsOthers ? SessionNews::tr(
                                  "%1 in the session file were changed outside this window, too. That is "
                                  "kept, and Reload (F5) shows it.")
                                  .arg(name)
                            : QString();
}

}  // namespace

SessionNews& SessionNews::of(Workspace& workspace) {
    auto* news = workspace.findChild<SessionNews*>(QString(), Qt::FindDirectChildrenOnly);
    return news != nullptr ? *news : *new SessionNews(workspace);
}

SessionNews::SessionNews(Workspace& workspace) : QObject(&workspace) {
    connect(&workspace, &Workspace::boardRead, this, [this](const LoadedBoard& board) { m_file = board.sessionFile; });
}

QString SessionNews::afterSave(const model::session::KnownPart& saved, const QString& name) {
    QStringList others;
    for (const std::string& part : model::session::otherNews(saved, m_file.get())) {
        others += nameOf(part);
    }
    m_file = saved.file;
    QStringList sentences;
    if (const QString text = textOfPart(saved, name); !text.isEmpty()) {
        sentences += text;
    }
    if (!others.isEmpty()) {
        sentences += tr("Another window changed the session file, too: %1. That is kept, and Reload (F5) shows it.")
                         .arg(others.join(QStringLiteral(", ")));
    }
    return sentences.join(QLatin1Char(' '));
}

}  // namespace ui
