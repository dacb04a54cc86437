"use strict";
document.documentElement.dataset.python = "absent";
