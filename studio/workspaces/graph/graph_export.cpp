#include "studio/workspaces/graph/graph_export.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QSvgGenerator>

#include <exception>

#include "core/project/graph_export.h"
#include "studio/app/core_words.h"
#include "studio/view3d/graph_view.h"
#include "studio/workspaces/graph/graph_centre.h"
#include "studio/workspaces/graph/matrix_page.h"
#include "studio/workspaces/graph/node_page.h"

namespace kumite::studio {

namespace {

/// Translations of this file.
struct GraphExport {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::GraphExport)
};

bool writePng(GraphCentre& centre, const QString& path) {
    if (!centre.showsMatrix()) return centre.nodes().view().picture().save(path, "PNG");
    constexpr int kScale = 2;  // so that small names can be read
    QImage image(centre.matrix().wholeSize() * kScale, QImage::Format_RGB32);
    image.setDevicePixelRatio(kScale);
    QPainter painter(&image);
    centre.matrix().paintWhole(painter);
    painter.end();
    return image.save(path, "PNG");
}

bool writeSvg(GraphCentre& centre, const QString& path) {
    const QSize size =
        centre.showsMatrix() ? centre.matrix().wholeSize() : centre.nodes().view().size();
    QSvgGenerator generator;
    generator.setFileName(path);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(), size));
    generator.setTitle(GraphExport::tr("Transitions"));
    QPainter painter;
    if (!painter.begin(&generator)) return false;
    if (centre.showsMatrix()) {
        centre.matrix().paintWhole(painter);
    } else {
        centre.nodes().view().paint(painter);
    }
    return painter.end();
}

}  // namespace

QString exportGraph(GraphCentre& centre, const GraphSession& graph, const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    bool written = false;
    if (suffix == QLatin1String("png")) {
        written = writePng(centre, path);
    } else if (suffix == QLatin1String("svg")) {
        written = writeSvg(centre, path);
    } else if (suffix == QLatin1String("csv") || suffix == QLatin1String("json") ||
               suffix == QLatin1String("graphml")) {
        try {
            writeGraph(graph.values()->interaction, path.toStdString());
            written = true;
        } catch (const std::exception& error) {
            return coreWords(error.what());
        }
    } else {
        return GraphExport::tr("%1: the name must end in .csv, .json, .graphml, .png or .svg.")
            .arg(path);
    }
    return written ? QString() : GraphExport::tr("%1: it cannot be written there.").arg(path);
}

}  // namespace kumite::studio
