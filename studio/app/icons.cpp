#include "studio/app/icons.h"

#include <QFile>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

#include <utility>

// The resources live in a static library: without this the linker drops them.
static void initResources() {
    Q_INIT_RESOURCE(studio);
}

namespace kumite::studio {

namespace {

QPixmap rendered(QByteArray svg, int size, double ratio) {
    const int pixels = qRound(size * ratio);
    QPixmap pixmap(pixels, pixels);
    pixmap.fill(Qt::transparent);
    QSvgRenderer renderer(svg);
    QPainter painter(&pixmap);
    renderer.render(&painter);
    painter.end();
    pixmap.setDevicePixelRatio(ratio);
    return pixmap;
}

QByteArray svgOf(const QString& name) {
    initResources();
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

QPixmap linePixmap(const QString& name, const QColor& colour, int size, double ratio) {
    QByteArray svg = svgOf(name);
    svg.replace("currentColor", colour.name().toLatin1());
    return rendered(svg, size, ratio);
}

QIcon lineIcon(const QString& name, const QColor& colour) {
    QIcon icon;
    // Those that are twice as large go along with larger text.
    for (const auto& [size, ratio] : {std::pair{16, 1.0}, {16, 2.0}, {32, 1.0}, {32, 2.0}}) {
        icon.addPixmap(linePixmap(name, colour, size, ratio));
        QPixmap faint = linePixmap(name, colour, size, ratio);
        QPainter painter(&faint);
        painter.setCompositionMode(QPainter::CompositionMode_DestinationIn);
        painter.fillRect(faint.rect(), QColor(0, 0, 0, 90));
        painter.end();
        icon.addPixmap(faint, QIcon::Disabled);
    }
    return icon;
}

QIcon applicationIcon() {
    QIcon icon;
    for (const int size : {16, 24, 32, 48, 64, 128, 256}) {
        icon.addPixmap(rendered(svgOf(QStringLiteral("kumite")), size, 1.0));
    }
    return icon;
}

}  // namespace kumite::studio
