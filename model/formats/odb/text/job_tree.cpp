#include "model/formats/odb/text/job_tree.h"

namespace model::odb {

base::Result<formats::FileTree> findJob(const formats::Archive& archive) {
    constexpr std::string_view kMatrix = "matrix/matrix";
    std::optional<std::string> shallowest;
    for (const auto& [path, row] : archive.rows()) {
        const std::string_view plain = path.ends_with(".z") ? std::string_view(path).substr(0, path.size() - 2) : path;
        if (plain != kMatrix && !plain.ends_with("/matrix/matrix")) {
            continue;
        }
        const std::string root(plain.substr(0, plain.size() - kMatrix.size()));
        if (formats::FileTree(archive, root).hasFolder("steps") && (!shallowest || root.size() < shallowest->size())) {
            shallowest = root;
        }
    }
    if (!shallowest) {
        return base::Error{base::ErrorCode::BadInput,
                           "this is no ODB++ job: no folder in it holds both matrix/matrix and steps/"};
    }
    return formats::FileTree(archive, *shallowest);
}

}  // namespace model::odb
