"""Settings of the kernels of a class, for the etc/ipython of its Python."""

c = get_config()
# A kernel listens on a port of the machine for what its forked processes print. Nobody else should
# reach a kernel, and the notebooks fork nothing.
c.IPKernelApp.exec_lines = [
    "_iopub = get_ipython().kernel.iopub_thread",
    "_iopub.io_loop.add_callback(_iopub._pipe_in.close)",
    "del _iopub",
]
