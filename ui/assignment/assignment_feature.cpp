#include "ui/assignment/assignment_feature.h"

#include <algorithm>
#include <utility>

#include "ui/assignment/assignment_dialog.h"
#include "ui/common/paths.h"

namespace ui {

namespace {

namespace fs = std::filesystem;
using model::gerber::LayerMap;
using model::gerber::LayerProposal;

bool isUnknown(const LayerProposal& proposal) {
    return proposal.isImage() && !proposal.role.isKnown();
}

}  // namespace

AssignmentFeature::AssignmentFeature(FeatureContext& context)
    : QObject(&context.window), m_window(context.window), m_workspace(context.workspace) {
    context.on(ActionId::AssignLayers, this, [this] { look(true); });
    connect(&m_workspace, &Workspace::openingBegan, this, [this] { m_search.cancel(); });
    connect(&m_workspace, &Workspace::boardLeaves, this, [this] { m_search.cancel(); });
    connect(&m_workspace, &Workspace::sessionRestored, this, &AssignmentFeature::onOpened);
    connect(&m_search.background(), &Background::finished, this, &AssignmentFeature::onFound);
}

fs::path AssignmentFeature::mapPath() const {
    const model::OpenRequest& request = m_workspace.board()->request;
    return request.layerMap.empty() ? model::gerber::layerMapBeside(request.path) : request.layerMap;
}

void AssignmentFeature::onOpened(const LoadedBoard& board) {
    if (!m_notice.isEmpty()) {
        m_workspace.reportError(std::exchange(m_notice, {}));
    }
    std::error_code error;
    const bool isToldAlready = fs::exists(mapPath(), error);
    if (board.format == "gerber" && !board.request.noSession && board.request.member.empty() && !isToldAlready &&
        m_offered.insert(board.request.path).second) {
        look(false);
    }
}

void AssignmentFeature::look(bool isAsked) {
    const LoadedBoard& board = *m_workspace.board();
    if (board.format != "gerber") {
        m_workspace.report(tr("Only Gerber jobs have files to assign; this board says itself what its layers are"));
        return;
    }
    if (!board.request.member.empty()) {
        m_workspace.reportError(tr("Layers of %1 cannot be assigned while it lies in another archive. Unpack it first.")
                                    .arg(QString::fromStdString(board.request.member)));
        return;
    }
    m_isAsked = isAsked;
    std::error_code error;
    m_search.run(
        [path = board.request.path, map = board.request.layerMap,
         isMapped = fs::exists(mapPath(), error)](base::Progress& progress) -> base::Result<Found> {
            model::formats::ReadOptions options;
            options.layerMap = map;
            ASSIGN_OR_RETURN(auto proposals, model::gerber::proposeLayers(path, options, progress));
            if (!isMapped) {
                return Found{proposals, proposals};
            }
            ASSIGN_OR_RETURN(auto unmapped, model::gerber::proposeWithoutMap(path, progress));
            return Found{std::move(proposals), std::move(unmapped)};
        },
        tr("Looking at the files"), tr("There is not enough memory to look at the files"));
}

void AssignmentFeature::onFound() {
    base::Result<Found> found = m_search.take();
    if (!found) {
        if (m_isAsked) {
            m_workspace.reportError(QString::fromStdString(found.error().text));
        }
        return;  // the board is open all the same, and its messages say what is wrong with it
    }
    if (m_isAsked || std::ranges::any_of(found->proposals, isUnknown)) {
        ask(std::move(*found));
    }
}

void AssignmentFeature::ask(Found found) {
    auto* dialog = new AssignmentDialog(displayName(m_workspace.board()->request.path), displayName(mapPath()),
                                        std::move(found.proposals), std::move(found.unmapped), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { take(dialog->map()); });
    dialog->open();
}

void AssignmentFeature::take(const LayerMap& map) {
    const fs::path path = mapPath();
    m_workspace.files().add(
        nullptr, [path, map] { return model::gerber::writeLayerMap(path, map); },
        [this, map, board = m_workspace.board()->request.path](const base::Status& written) {
            if (!written && m_workspace.board()->request.path == board) {
                takeForNow(map, QString::fromStdString(written.error().text));
            }
        });
    m_workspace.reload();
}

void AssignmentFeature::takeForNow(const LayerMap& map, const QString& why) {
    m_temporary.emplace();
    const fs::path path = toPath(m_temporary->filePath(fromPath(mapPath().filename())));
    m_workspace.files().add(
        nullptr, [path, map] { return model::gerber::writeLayerMap(path, map); },
        [this](const base::Status& written) {
            if (!written) {
                m_notice.clear();
                m_workspace.reportError(QString::fromStdString(written.error().text));
            }
        });
    m_notice = tr("The layers hold until the window is closed: %1").arg(why);
    m_workspace.reload([&](model::OpenRequest& request) { request.layerMap = path; });
}

}  // namespace ui
