#include "meshes/read/vtk_complaints.h"

#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>

namespace tw {
namespace {

class KeptOutput : public vtkOutputWindow {
public:
    static KeptOutput* New();
    vtkTypeMacro(KeptOutput, vtkOutputWindow);
    KeptOutput(const KeptOutput&) = delete;
    KeptOutput& operator=(const KeptOutput&) = delete;
    void DisplayText(const char* text) override {
        if (kept.empty() && text != nullptr) kept = text;
    }
    std::string kept;

protected:
    KeptOutput() = default;
};
vtkStandardNewMacro(KeptOutput);

}  // namespace

VtkComplaints::VtkComplaints()
    : before_(vtkOutputWindow::GetInstance()),
      ours_(vtkSmartPointer<KeptOutput>::New()),
      verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkOutputWindow::SetInstance(ours_);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);  // VTK prints beside its output window
}

VtkComplaints::~VtkComplaints() {
    vtkOutputWindow::SetInstance(before_);
    vtkLogger::SetStderrVerbosity(verbosity_);
}

std::string VtkComplaints::first() const {
    const std::string& text = static_cast<const KeptOutput&>(*ours_).kept;
    const auto address = text.find("): ");
    std::string message = address == std::string::npos ? text : text.substr(address + 3);
    std::ranges::replace(message, '\n', ' ');
    while (!message.empty() && message.back() == ' ') message.pop_back();
    return message;
}

}  // namespace tw
