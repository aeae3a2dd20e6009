// Imported first: the browser opens its database while the rest of the page is still being evaluated.
import {open_work_store} from "./work_store";

export const opening = open_work_store();
