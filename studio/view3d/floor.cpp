#include "studio/view3d/floor.h"

#include <QFont>
#include <QImage>
#include <QPainter>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "studio/view3d/figure.h"

namespace kumite::studio {

namespace {

constexpr int kNumbersTo = 20;  ///< metres either way
constexpr int kCellWidth = 96;  ///< of one number in the picture of all, pixels
constexpr int kCellHeight = 48;

void show(vtkPolyData* data, vtkActor* actor, vtkRenderer* renderer) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->ForceOpaqueOn();
    renderer->AddActor(actor);
}

/// The numbers from -kNumbersTo to kNumbersTo one below the other, white on nothing.
QImage numberPicture() {
    constexpr int kCount = 2 * kNumbersTo + 1;
    QImage picture(kCellWidth, kCellHeight * kCount, QImage::Format_RGBA8888);
    picture.fill(QColor(255, 255, 255, 0));
    QPainter painter(&picture);
    QFont font;
    font.setPixelSize(38);
    painter.setFont(font);
    painter.setPen(Qt::white);
    for (int i = 0; i < kCount; ++i) {
        QString text = QString::number(i - kNumbersTo);
        text.replace(QLatin1Char('-'), QChar(0x2212));
        painter.drawText(QRect(0, i * kCellHeight, kCellWidth, kCellHeight), Qt::AlignCenter, text);
    }
    painter.end();
    // Half-covered pixels must not darken: the colour is white everywhere.
    for (int y = 0; y < picture.height(); ++y) {
        uchar* line = picture.scanLine(y);
        for (int x = 0; x < picture.width(); ++x)
            line[4 * x] = line[4 * x + 1] = line[4 * x + 2] = 255;
    }
    // VTK's first row is the lowest.
    return picture.mirrored();
}

}  // namespace

Floor::Floor(vtkRenderer* renderer) {
    show(lines_, lineActor_, renderer);
    show(numbers_, numberActor_, renderer);
    const QImage picture = numberPicture();
    digits_->SetDimensions(picture.width(), picture.height(), 1);
    digits_->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    std::memcpy(digits_->GetScalarPointer(), picture.constBits(),
                static_cast<std::size_t>(picture.sizeInBytes()));
    vtkNew<vtkTexture> texture;
    texture->SetInputData(digits_);
    texture->InterpolateOn();
    texture->MipmapOn();
    texture->RepeatOff();
    texture->EdgeClampOn();
    numberActor_->SetTexture(texture);
}

void Floor::setColours(const Colours& colours) {
    if (colours_ == &colours) return;
    colours_ = &colours;
    draw();
}

void Floor::cover(const Box& box) {
    if (box.empty()) return;
    const Eigen::Vector3d middle = box.centre();
    centre_ = {std::round(middle.x()), std::round(middle.z())};
    const Eigen::Vector3d size = box.high - box.low;
    radius_ = std::clamp(0.5 * std::hypot(size.x(), size.z()) + 3.0, 5.0, 60.0);
    draw();
}

void Floor::draw() {
    if (colours_ == nullptr) return;
    drawLines();
    drawNumbers();
}

void Floor::drawLines() {
    constexpr double kStep = 0.5;
    const int reach = static_cast<int>(std::ceil(radius_ / kStep));
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkUnsignedCharArray> shades;
    shades->SetNumberOfComponents(4);
    const QColor plain = mixed(colours_->line, colours_->secondText, 0.45);
    const QColor axis = mixed(colours_->line, colours_->secondText, 0.95);
    const auto put = [&](double x, double z, double weight, const QColor& colour) {
        const double away = std::hypot(x - centre_.x(), z - centre_.y()) / radius_;
        const double fade = std::max(0.0, 1 - away * away);
        points->InsertNextPoint(x, -kSole, z);
        shades->InsertNextTuple4(colour.red(), colour.green(), colour.blue(), 255 * weight * fade);
    };
    for (int line = -reach; line <= reach; ++line) {
        for (const bool alongX : {true, false}) {
            const double place = (alongX ? centre_.y() : centre_.x()) + kStep * line;
            const bool isAxis = std::abs(place) < 1e-9;
            const double weight = line % 2 == 0 ? 0.9 : 0.3;
            vtkIdType previous = -1;
            for (int at = -reach; at <= reach; ++at) {
                const double along = (alongX ? centre_.x() : centre_.y()) + kStep * at;
                put(alongX ? along : place, alongX ? place : along, weight, isAxis ? axis : plain);
                const vtkIdType corner = points->GetNumberOfPoints() - 1;
                if (previous >= 0) {
                    const vtkIdType ends[2] = {previous, corner};
                    lines->InsertNextCell(2, ends);
                }
                previous = corner;
            }
        }
    }
    lines_->SetPoints(points);
    lines_->SetLines(lines);
    lines_->GetPointData()->SetScalars(shades);
}

void Floor::drawNumbers() {
    constexpr double kHeight = 0.16;
    constexpr double kWidth = kHeight * kCellWidth / kCellHeight;
    constexpr int kCount = 2 * kNumbersTo + 1;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkFloatArray> corners;
    corners->SetNumberOfComponents(2);
    vtkNew<vtkUnsignedCharArray> shades;
    shades->SetNumberOfComponents(4);
    const QColor colour = colours_->secondText;
    const auto write = [&](int number, double x, double z) {
        const double away = std::hypot(x - centre_.x(), z - centre_.y()) / radius_;
        const double fade = std::max(0.0, 1 - away * away);
        if (fade <= 0.02) return;
        cells->InsertNextCell(4);
        // The first row of the picture is the highest number's.
        const double low = static_cast<double>(kNumbersTo - number) / kCount;
        for (const auto& [u, v] :
             {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
            points->InsertNextPoint(x + kWidth * (u - 0.5), -kSole + 0.001,
                                    z - kHeight * (v - 0.5));
            corners->InsertNextTuple2(u, low + static_cast<double>(v) / kCount);
            shades->InsertNextTuple4(colour.red(), colour.green(), colour.blue(), 230 * fade);
            cells->InsertCellPoint(points->GetNumberOfPoints() - 1);
        }
    };
    for (int number = -kNumbersTo; number <= kNumbersTo; ++number) {
        // Beside the crossings that they name.
        write(number, number + 0.13, 0.12);
        if (number != 0) write(number, 0.13, number + 0.12);
    }
    numbers_->SetPoints(points);
    numbers_->SetPolys(cells);
    numbers_->GetPointData()->SetTCoords(corners);
    numbers_->GetPointData()->SetScalars(shades);
}

}  // namespace kumite::studio
