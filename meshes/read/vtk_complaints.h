#pragma once
#include <vtkLogger.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkOutputWindow;

namespace tw {

/// While this lives, VTK's complaints, also those of the objects that a reader makes for itself, are kept and stay off
/// the terminal.
class VtkComplaints {
public:
    VtkComplaints();
    ~VtkComplaints();
    VtkComplaints(const VtkComplaints&) = delete;
    VtkComplaints& operator=(const VtkComplaints&) = delete;
    /// The first one without VTK's file, line and address; empty: none.
    std::string first() const;

private:
    vtkSmartPointer<vtkOutputWindow> before_, ours_;
    vtkLogger::Verbosity verbosity_;
};

}  // namespace tw
